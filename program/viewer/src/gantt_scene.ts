// The data and tools from which a Gantt chart is drawn.
import { GanttGeometry } from './gantt_geometry';
import { Palette } from './palette';
import { ShownStep } from './shown_step';
import { State } from './state';

export interface GanttScene {
  readonly context: CanvasRenderingContext2D;
  readonly geometry: GanttGeometry;
  readonly shown: ShownStep;
  /** Says which nodes are filtered and whether the critical path is shown. */
  readonly state: State;
  readonly palette: Palette;
}
