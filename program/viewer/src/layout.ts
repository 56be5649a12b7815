// Places the nodes of one pass: rows by longest-path level, lanes by subsystem (blade), the order
// within a lane by barycentre sweeps. Nodes of no subsystem stand in rows of their own, centred.
import { Adjacency } from './adjacency';
import { StepGraph } from './trace';

export interface Lane {
  subsystem: number;
  left: number;
  width: number;
}

export interface Row {
  top: number;
  height: number;
  stages: number[];
}

/** x, y are centres; the origin is the top left corner. */
export interface GraphLayout {
  x: Float64Array;
  y: Float64Array;
  width: Float64Array;
  nodeHeight: number;
  lanes: Lane[];
  rows: Row[];
  totalWidth: number;
  totalHeight: number;
}

const kCellWidth = 40;
const kCellHeight = 26;
const kNodeHeight = 20;
const kLaneGap = 20;
const kRowGap = 13;
const kWideNode = 86;
// The proportions of the panel that a layout should fill.
const kPanel = { width: 420, height: 370 };
// The smallest scale at which nodes have legible names.
const kReadable = 0.6;

interface Group {
  level: number;
  /** -1 = nodes of no subsystem. */
  lane: number;
  nodes: number[];
}

function groupsOf(graph: StepGraph, level: Int32Array, laneOf: (node: number) => number): Group[] {
  const groups = new Map<string, Group>();
  for (let node = 0; node < graph.count; ++node) {
    const lane = laneOf(node);
    const key = `${level[node]} ${lane}`;
    const group = groups.get(key) ?? { level: level[node], lane, nodes: [] };
    if (group.nodes.length === 0) groups.set(key, group);
    group.nodes.push(node);
  }
  return [...groups.values()].sort((a, b) => a.level - b.level || a.lane - b.lane);
}

/** Sorts each group by the mean place of its nodes' neighbours, downwards and upwards in turn. */
function sweep(groups: Group[], graph: StepGraph, adjacency: Adjacency): void {
  const place = new Float64Array(graph.count);
  const settle = (group: Group) => group.nodes.forEach((node, k) => (place[node] = (k + 0.5) / group.nodes.length));
  for (const group of groups) {
    group.nodes.sort((a, b) => graph.stage[a] - graph.stage[b] || graph.body[a] - graph.body[b] || a - b);
    settle(group);
  }
  for (let round = 0; round < 6; ++round) {
    const rows = round % 2 === 0 ? adjacency.predecessors : adjacency.successors;
    for (const group of round % 2 === 0 ? groups : [...groups].reverse()) {
      const centre = new Map<number, number>();
      for (const node of group.nodes) {
        const near = rows.of(node);
        let sum = 0;
        for (const other of near) sum += place[other];
        centre.set(node, near.length > 0 ? sum / near.length : place[node]);
      }
      const rank = (node: number) => centre.get(node) as number;
      group.nodes.sort((a, b) => rank(a) - rank(b) || graph.body[a] - graph.body[b] || a - b);
      settle(group);
    }
  }
}

/** How many columns a lane gets: all that it needs if the graph is then readable, or else as many as
 *  show the whole graph largest. */
function bestColumns(groups: Group[], lanes: number, most: number): number {
  let best = { columns: 1, scale: 0 };
  for (let columns = most; columns >= 1; --columns) {
    const width = lanes * (laneWidth(columns, lanes) + kLaneGap);
    const depth = new Map<number, number>();
    for (const group of groups) {
      const rows = Math.ceil(group.nodes.length / columns);
      depth.set(group.level, Math.max(depth.get(group.level) ?? 0, rows));
    }
    let height = 0;
    for (const rows of depth.values()) height += rows * kCellHeight + kRowGap;
    const scale = Math.min(kPanel.width / width, kPanel.height / height);
    if (scale > best.scale * 1.001) best = { columns, scale };
    if (columns === most && scale > kReadable) break;
  }
  return best.columns;
}

function laneWidth(columns: number, lanes: number): number {
  return Math.max(columns * kCellWidth, lanes <= 8 ? kWideNode + 8 : kCellWidth);
}

export function layoutGraph(graph: StepGraph, adjacency: Adjacency): GraphLayout {
  const subsystems = [...new Set(graph.subsystem)].filter((s) => s >= 0).sort((a, b) => a - b);
  const laneIndex = new Map(subsystems.map((subsystem, k) => [subsystem, k]));
  if (subsystems.length === 0) laneIndex.set(-1, 0);
  const groups = groupsOf(graph, adjacency.level, (node) => laneIndex.get(graph.subsystem[node]) ?? -1);
  sweep(groups, graph, adjacency);

  const count = Math.max(1, subsystems.length);
  const inLanes = groups.filter((group) => group.lane >= 0);
  const most = inLanes.reduce((most, group) => Math.max(most, group.nodes.length), 1);
  const columns = bestColumns(inLanes, count, most);
  const width = laneWidth(columns, count);
  const lanes = Array.from({ length: count }, (_, k) => ({
    subsystem: subsystems[k] ?? -1, left: k * (width + kLaneGap), width,
  }));
  const layout: GraphLayout = {
    x: new Float64Array(graph.count), y: new Float64Array(graph.count), width: new Float64Array(graph.count),
    nodeHeight: kNodeHeight, lanes, rows: [],
    totalWidth: count * (width + kLaneGap) - kLaneGap, totalHeight: 0,
  };
  placeRows(layout, graph, adjacency, groups, columns);
  return layout;
}

function placeRows(layout: GraphLayout, graph: StepGraph, adjacency: Adjacency, groups: Group[], columns: number): void {
  const levels = [...new Set(groups.map((group) => group.level))].sort((a, b) => a - b);
  let top = 0;
  const addRow = (members: Group[], place: (group: Group) => number) => {
    if (members.length === 0) return;
    const height = Math.max(...members.map(place)) * kCellHeight;
    const stages = [...new Set(members.flatMap((group) => group.nodes.map((node) => graph.stage[node])))];
    layout.rows.push({ top, height, stages: stages.sort((a, b) => a - b) });
    top += height + kRowGap;
  };
  for (const level of levels) {
    const here = groups.filter((group) => group.level === level);
    const system = here.filter((group) => group.lane < 0);
    const isSource = system.some((g) => g.nodes.some((n) => adjacency.predecessors.of(n).length === 0));
    const placeSystem = (group: Group) => placeGroup(layout, group, 0, layout.totalWidth, top, Math.max(1, Math.floor(layout.totalWidth / (kWideNode + 16))));
    if (isSource) addRow(system, placeSystem);
    addRow(here.filter((group) => group.lane >= 0), (group) => {
      const lane = layout.lanes[group.lane];
      return placeGroup(layout, group, lane.left, lane.width, top, columns);
    });
    if (!isSource) addRow(system, placeSystem);
  }
  layout.totalHeight = Math.max(0, top - kRowGap);
}

/** Returns the number of lines that the group takes. */
function placeGroup(layout: GraphLayout, group: Group, left: number, width: number, top: number, columns: number): number {
  const lines = Math.ceil(group.nodes.length / columns);
  group.nodes.forEach((node, k) => {
    const line = Math.floor(k / columns);
    const inLine = lines === 1 ? group.nodes.length : columns;
    const cell = lines === 1 ? Math.min(width / inLine, kWideNode + 14) : kCellWidth;
    const from = left + (width - inLine * cell) / 2;
    layout.x[node] = from + ((k % columns) + 0.5) * cell;
    layout.y[node] = top + (line + 0.5) * kCellHeight;
    layout.width[node] = Math.min(kWideNode, cell - 6);
  });
  return lines;
}
