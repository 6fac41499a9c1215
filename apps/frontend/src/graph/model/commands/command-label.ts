import type { Graph, GraphNode, PortRef, Standing } from '../graph.ts';
import { ioName } from '../ports.ts';
import type { GraphCommand } from './graph-command.ts';

/** Label of a command in the history: `Connect pointer to mirror · position`. */
export function commandLabel(graph: Graph, command: GraphCommand): string {
  const name = (id: string): string => nodeName(graph.nodes.get(id));
  switch (command.kind) {
    case 'all':
    case 'patch':
      return command.label;
    case 'add':
      return command.label ?? `Add ${several(command.nodes, nodeName)}`;
    case 'remove':
      return removal(graph, command.nodes ?? [], command.wires ?? []);
    case 'move':
      return `Move ${several([...command.positions.keys()], name)}`;
    case 'resize':
      return `Resize ${name(command.node)}`;
    case 'collapse':
      return `${command.isCollapsed ? 'Collapse' : 'Expand'} ${several(command.nodes, name)}`;
    case 'connect':
      return `Connect ${portName(graph, command.from)} to ${portName(graph, command.to)}`;
    case 'reroute':
      return 'Reroute a wire';
    case 'setModule':
      return `Change ${moduleMembers(Object.keys(command.changes))} of ${name(command.node)}`;
    case 'setConstant':
      return `${command.json === undefined ? 'Reset' : 'Set'} ${command.input || 'an input'} of ${name(command.node)}`;
    case 'setStanding':
      return `${STANDING_WORDS[command.standing]} ${several(command.nodes, name)}`;
    case 'setMuxer':
    case 'setDemuxer':
    case 'setValue':
      return `Change ${name(command.node)}`;
    case 'setText':
      return `Edit ${name(command.node)}`;
    case 'setColor':
      return `Colour ${name(command.frame)}`;
    case 'renameTopic':
      return `Change the topic ${name(command.node)} to ${command.topic || 'none'}`;
    case 'setVia':
      return `Change the topic of a wire to ${command.topic || 'none'}`;
    case 'ownTopics':
      return 'Use topics of its own';
    case 'showTopic':
      return `Show the topic ${graph.wires.get(command.wire)?.via ?? ''}`.trimEnd();
    case 'hideTopic':
      return `Show ${name(command.node)} as a wire`;
    case 'group':
      return `Frame ${several(command.nodes, name)}`;
    case 'ungroup':
      return `Remove ${name(command.frame)}`;
    case 'setFrame':
      return command.frame === undefined
        ? `Remove ${several(command.nodes, name)} from the frame`
        : `Move ${several(command.nodes, name)} into ${name(command.frame)}`;
    case 'setDetails':
      return `Change the ${detailWords(Object.keys(command.changes))} of the session`;
  }
}

/** Display name of a node. */
export function nodeName(node: GraphNode | undefined): string {
  switch (node?.kind) {
    case undefined:
      return 'a deleted node';
    case 'topic':
      return node.topic;
    case 'module':
      return node.module.name || 'a module without a name';
    case 'muxer':
      return node.mux.name || 'the muxer';
    case 'demuxer':
      return node.demux.name || 'the demuxer';
    case 'constant':
      return node.name || 'the constant';
    case 'comment':
      return 'the comment';
    case 'frame':
      return node.title === '' ? 'the frame' : `the frame ${node.title}`;
  }
}

/** `mirror · position`, or only the node's name when it has one port. */
export function portName(graph: Graph, { node, port }: PortRef): string {
  const owner = graph.nodes.get(node);
  const name = nodeName(owner);
  const io = owner?.kind === 'module' ? ioName(port) : '';
  return io === '' ? name : `${name} · ${io}`;
}

function several<T>(things: readonly T[], nameOf: (thing: T) => string): string {
  const [only] = things;
  return things.length === 1 && only !== undefined ? nameOf(only) : `${things.length} nodes`;
}

function removal(graph: Graph, nodes: readonly string[], wires: readonly string[]): string {
  if (nodes.length > 0) return `Delete ${several(nodes, (id) => nodeName(graph.nodes.get(id)))}`;
  const wire = wires.length === 1 ? graph.wires.get(wires[0] ?? '') : undefined;
  if (wire === undefined) return `Disconnect ${wires.length} wires`;
  return `Disconnect ${portName(graph, wire.from)} from ${portName(graph, wire.to)}`;
}

const STANDING_WORDS: Readonly<Record<Standing, string>> = {
  active: 'Use',
  bypassed: 'Bypass',
  muted: 'Mute',
};

const MODULE_WORDS: Readonly<Record<string, string>> = {
  name: 'the name',
  nodeId: 'the place',
  // Contains whether the master may move the module.
  extension: 'the place',
  processingMode: 'the mode',
  inputs: 'the inputs',
  outputs: 'the outputs',
  description: 'the description',
  onProcessingStringified: 'the code',
  onCreatedStringified: 'the code',
  onHaltedStringified: 'the code',
  onDestroyedStringified: 'the code',
};

function moduleMembers(members: readonly string[]): string {
  const words = [...new Set(members.map((member) => MODULE_WORDS[member] ?? 'settings'))];
  return words.length === 1 ? words[0]! : 'settings';
}

const DETAIL_WORDS: Readonly<Record<string, string>> = {
  name: 'name',
  description: 'description',
  tags: 'tags',
  authors: 'authors',
  editable: 'protection',
  startWithMaster: 'start',
  lockstepHertz: 'lockstep rate',
};

function detailWords(members: readonly string[]): string {
  return members.map((member) => DETAIL_WORDS[member] ?? member).join(' and ');
}
