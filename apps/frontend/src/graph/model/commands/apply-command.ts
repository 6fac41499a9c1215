import type { Graph } from '../graph.ts';
import { topicNodeId } from '../make-node.ts';
import { wouldLoop } from '../nesting.ts';
import { commandLabel } from './command-label.ts';
import { connect, isLegal, replaceValue } from './connect.ts';
import {
  editNode,
  moved,
  setConstant,
  setDemuxer,
  setModule,
  setMuxer,
  setStanding,
  setColor,
  setText,
  setValue,
} from './edit-node.ts';
import type { CommandKind, CommandOf, GraphCommand } from './graph-command.ts';
import { GraphEdit, type GraphPatch } from './graph-edit.ts';
import { followName, ownTopics, withOwnTopics } from './own-topics.ts';
import { revealTopic } from './reveal-topic.ts';
import { nothingElsewhere } from './topics-elsewhere.ts';
import { hideTopic, placeTopics, renameTopic, setVia, showTopic } from './topic-commands.ts';

/** Result of a command. */
export interface Applied {
  readonly graph: Graph;
  /** Command that reverts it. */
  readonly inverse: CommandOf<'patch'>;
  /** Patch that applies it again. */
  readonly redo: GraphPatch;
}

/**
 * Applies a command and returns a new graph; the given graph itself if nothing changes.
 * @param elsewhere returns the topics that others use, which new wires avoid
 */
export function applyCommand(
  graph: Graph,
  command: GraphCommand,
  elsewhere = nothingElsewhere,
): Applied {
  const edit = new GraphEdit(graph, elsewhere);
  const label = commandLabel(graph, command);
  run(edit, command);
  return {
    graph: edit.graph,
    inverse: { kind: 'patch', patch: edit.undoing(), label },
    redo: edit.redoing(),
  };
}

type Runner<K extends CommandKind> = (edit: GraphEdit, command: CommandOf<K>) => void;

const RUNNERS: { readonly [K in CommandKind]: Runner<K> } = {
  all: (edit, { commands }) => {
    for (const command of commands) run(edit, command);
  },
  patch: (edit, { patch }) => edit.apply(patch),
  add: (edit, { nodes, wires: given = [] }) => {
    placeTopics(edit, nodes);
    edit.putNodes(nodes);
    const wires = withOwnTopics(edit, given);
    const legal = wires.filter(({ from, to }) => isLegal(edit.graph, from, to));
    edit.putWires(legal);
    for (const wire of legal) replaceValue(edit, wire);
    for (const { via } of wires) {
      if (via !== undefined && edit.graph.nodes.has(topicNodeId(via))) revealTopic(edit, via);
    }
  },
  remove: (edit, { nodes = [], wires = [] }) => {
    edit.removeWires(wires);
    edit.removeNodes(nodes);
  },
  move: (edit, { positions }) => {
    edit.putNodes(moved(edit.graph, positions));
  },
  resize: (edit, { node, size, position }) =>
    editNode(edit, node, (old) => ({ ...old, size, position: position ?? old.position })),
  collapse: (edit, { nodes, isCollapsed }) => {
    for (const id of nodes) editNode(edit, id, (old) => ({ ...old, isCollapsed }));
  },
  connect,
  reroute: (edit, { wire, points }) => {
    const old = edit.graph.wires.get(wire);
    if (old !== undefined) edit.putWires([{ ...old, points }]);
  },
  setModule,
  setConstant,
  setStanding,
  setMuxer,
  setDemuxer,
  setValue,
  setText,
  setColor,
  renameTopic,
  setVia,
  showTopic,
  hideTopic,
  group: (edit, { frame, nodes }) => {
    edit.putNodes([frame]);
    putInto(edit, nodes, frame.id);
  },
  ungroup: (edit, { frame }) => {
    if (edit.graph.nodes.get(frame)?.kind === 'frame') edit.removeNodes([frame]);
  },
  setFrame: (edit, { nodes, frame }) => {
    putInto(edit, nodes, frame);
  },
  ownTopics,
  setDetails: (edit, { changes }) => {
    const { details } = edit.graph;
    edit.setDetails({ ...details, ...changes });
    followName(edit, details.name);
  },
};

/** Prevents frames from containing themselves, directly or indirectly. */
function putInto(edit: GraphEdit, nodes: readonly string[], frame: string | undefined): void {
  for (const id of nodes) {
    if (frame !== undefined && wouldLoop(edit.graph.nodes, id, frame)) continue;
    editNode(edit, id, (old) => ({ ...old, frame }));
  }
}

function run(edit: GraphEdit, command: GraphCommand): void {
  (RUNNERS[command.kind] as Runner<CommandKind>)(edit, command);
}
