// Builds the viewer. esbuild is taken from node_modules of the working directory, or of this folder.
//   node build.mjs page FILE.html        the page in one file, its trace still null
//   node build.mjs embed FILE.cpp        the same as C++ source that defines spoke::graph::viewer_page()
//   node build.mjs tests FOLDER          the unit tests, to be run by node --test FOLDER
import { mkdirSync, readdirSync, readFileSync, writeFileSync } from 'node:fs';
import { createRequire } from 'node:module';
import { basename, dirname, join } from 'node:path';
import { fileURLToPath } from 'node:url';

const root = dirname(fileURLToPath(import.meta.url));

function loadEsbuild() {
  for (const folder of [process.cwd(), root]) {
    try {
      return createRequire(join(folder, 'package.json'))('esbuild');
    } catch {
      // look in the next folder
    }
  }
  throw new Error('esbuild is not installed: run npm ci first');
}

const esbuild = loadEsbuild();

/** The page's parts, put together. */
async function buildPage() {
  const program = await esbuild.build({
    entryPoints: [join(root, 'src/main.ts')], bundle: true, minify: true, write: false,
    format: 'iife', target: ['chrome111', 'firefox113', 'safari16.4'], charset: 'ascii', legalComments: 'none',
  });
  const styles = await esbuild.transform(readFileSync(join(root, 'src/styles.css'), 'utf8'), {
    loader: 'css', minify: true, target: ['chrome111', 'firefox113', 'safari16.4'],
  });
  const page = readFileSync(join(root, 'src/index.html'), 'utf8')
    .replace('/*styles*/', () => styles.code.trim())
    .replace('/*program*/', () => program.outputFiles[0].text.trim());
  const place = '<script type="application/json" id="spoke-trace">null</script>';
  if (page.split(place).length !== 2) throw new Error(`the page must contain ${place} once`);
  return page;
}

/** C++ source with the page as raw strings, none longer than compilers must accept. */
function asSource(page) {
  const pieces = [];
  const characters = Array.from(page);
  for (let k = 0; k < characters.length; k += 12000) pieces.push(characters.slice(k, k + 12000).join(''));
  if (page.includes(')spoke"')) throw new Error('the page contains the mark that ends a raw string');
  return `// Written by graph/viewer/build.mjs.
#include "graph/viewer/viewer_page.h"

#include <string>

namespace spoke::graph {
namespace {

constexpr std::string_view kPieces[] = {
${pieces.map((piece) => `R"spoke(${piece})spoke"`).join(',\n')}};

std::string joined() {
  std::string page;
  for (std::string_view piece : kPieces) page += piece;
  return page;
}

}  // namespace

std::string_view viewer_page() {
  static const std::string page = joined();
  return page;
}

}  // namespace spoke::graph
`;
}

async function buildTests(folder) {
  const tests = readdirSync(join(root, 'test')).filter((name) => name.endsWith('.test.ts'));
  await esbuild.build({
    entryPoints: tests.map((name) => join(root, 'test', name)), bundle: true, platform: 'node', format: 'esm',
    target: 'node18', loader: { '.css': 'text' }, outdir: folder, outExtension: { '.js': '.mjs' }, logLevel: 'warning',
  });
}

const [what, target] = process.argv.slice(2);
if (!target || !['page', 'embed', 'tests'].includes(what)) {
  console.error(`usage: node ${basename(process.argv[1])} page|embed|tests TARGET`);
  process.exit(2);
}
if (what === 'tests') await buildTests(target);
else {
  const page = await buildPage();
  mkdirSync(dirname(target), { recursive: true });
  writeFileSync(target, what === 'page' ? page : asSource(page));
}
