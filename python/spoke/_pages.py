"""Pages of Spoke's in notebooks."""

import html

from ._spoke import StateError


def frame(shown):
    """What has a page, in a frame of its own: its styles and scripts touch nothing around it."""
    try:
        page = shown.page()
    except StateError as error:
        return f"<pre>{html.escape(f'{shown!r}: {error}')}</pre>"
    return (f'<iframe srcdoc="{html.escape(page, quote=True)}" '
            'style="width: 100%; height: 40em; border: 0"></iframe>')
