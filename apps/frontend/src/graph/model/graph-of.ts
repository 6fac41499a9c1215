import { fromJson, type MessageType, type Session } from '@ubii/proto';
import { parseEditorData, type EditorData, type NodeRecord } from './editor-data.ts';
import {
  wireId,
  type Graph,
  type GraphNode,
  type PortRef,
  type Standing,
  type Wire,
} from './graph.ts';
import {
  commentNode,
  constantNode,
  demuxerNode,
  demuxerNodeId,
  frameNode,
  moduleNode,
  muxerNode,
  muxerNodeId,
  topicNode,
  topicNodeId,
} from './make-node.ts';
import { IN, inputPort, OUT, outputPort } from './ports.ts';
import {
  endKey,
  readModules,
  type InputSource,
  type MappedModule,
  type OutputTarget,
} from './read-mappings.ts';
import { sessionDetails } from './session-details.ts';
import { restored, type Aside } from './standing/set-aside.ts';

/**
 * Converts a session to a graph; `sessionOf` is the inverse. Equal sessions give equal graphs. Topics that one module
 * writes and others read have no node, only wires with their name, unless the editor data says otherwise.
 */
export function graphOf(session: Session): Graph {
  const data = parseEditorData(session.extension?.editorJson ?? '');
  const modules = readModules(restored(session, data.aside));
  const builder = new GraphBuilder(data, modules, standings(session, data.aside));
  for (const module of modules) builder.addModule(module);
  for (const module of modules) builder.addInputs(module);
  for (const module of modules) builder.addOutputs(module);
  builder.addEditorNodes();
  return {
    nodes: builder.nodes,
    wires: builder.wires,
    details: sessionDetails(session),
    foreign: data.foreign,
  };
}

class GraphBuilder {
  readonly nodes = new Map<string, GraphNode>();
  readonly wires = new Map<string, Wire>();
  readonly #data: EditorData;
  readonly #standings: ReadonlyMap<string, Standing>;
  /** Topics without a node, with the output that writes them. */
  readonly #writers: ReadonlyMap<string, PortRef>;
  /** Node ids of muxers and demuxers, by a key of their content. */
  readonly #spreaders = new Map<string, string>();

  constructor(
    data: EditorData,
    modules: readonly MappedModule[],
    standings: ReadonlyMap<string, Standing>,
  ) {
    this.#data = data;
    this.#standings = standings;
    this.#writers = findWriters(modules, (topic) => data.nodes.has(topicNodeId(topic)));
  }

  addModule({ nodeId, module, inputs, outputs }: MappedModule): void {
    const constants = new Map<string, string>();
    for (const [name, { constantJson }] of inputs) {
      if (constantJson !== '') constants.set(name, constantJson);
    }
    const standing = this.#standings.get(module.id) ?? 'active';
    const names = { mappedInputs: inputs.keys(), mappedOutputs: outputs.keys() };
    this.#add(
      moduleNode(module, { ...this.#look(nodeId), id: nodeId, constants, standing, ...names }),
    );
  }

  addInputs({ nodeId, inputs }: MappedModule): void {
    for (const [name, { sources }] of inputs) {
      const to = { node: nodeId, port: inputPort(name) };
      for (const source of sources) this.#addInput(source, to);
    }
  }

  addOutputs({ nodeId, outputs }: MappedModule): void {
    for (const [name, targets] of outputs) {
      const from = { node: nodeId, port: outputPort(name) };
      for (const target of targets) this.#addOutput(from, target);
    }
  }

  /** Adds constants, comments, frames, and nodes without wires. */
  addEditorNodes(): void {
    for (const [id, record] of this.#data.nodes) {
      if (this.nodes.has(id)) continue;
      const node = editorNode(id, record);
      if (node === undefined) continue;
      this.#add(node);
      if (node.kind === 'constant') this.#wireConstant(node.id, node.json, record.targets ?? []);
    }
  }

  #addInput(source: InputSource, to: PortRef): void {
    if (source.kind === 'muxer') {
      const { mux } = source;
      const key = endKey(source);
      const id = this.#spreader(key, muxerNodeId(mux.id), mux.id === '' ? to : undefined);
      if (!this.nodes.has(id)) this.#add(muxerNode(mux, { ...this.#look(id), id }));
      this.#connect({ node: id, port: OUT }, to);
      return;
    }
    const writer = this.#writers.get(source.topic);
    if (writer !== undefined) this.#connect(writer, to, source.topic);
    else this.#connect({ node: this.#topic(source.topic), port: OUT }, to);
  }

  #addOutput(from: PortRef, target: OutputTarget): void {
    if (target.kind === 'demuxer') {
      const { demux } = target;
      const key = endKey(target);
      const id = this.#spreader(key, demuxerNodeId(demux.id), demux.id === '' ? from : undefined);
      if (!this.nodes.has(id)) this.#add(demuxerNode(demux, { ...this.#look(id), id }));
      this.#connect(from, { node: id, port: IN });
    } else if (!this.#writers.has(target.topic)) {
      this.#connect(from, { node: this.#topic(target.topic), port: IN });
    }
  }

  /**
   * Returns one node for mappings with the same id and content. Without an id, as from old clients, each mapping has
   * its own node.
   */
  #spreader(key: string, id: string, place: PortRef | undefined): string {
    const wholeKey = place === undefined ? key : `${key} ${place.node} ${place.port}`;
    const known = this.#spreaders.get(wholeKey);
    if (known !== undefined) return known;
    const wished = place === undefined ? id : `${id}${place.node} ${place.port}`;
    const free = freeKey(this.nodes, wished);
    this.#spreaders.set(wholeKey, free);
    return free;
  }

  #topic(topic: string): string {
    const id = topicNodeId(topic);
    const { format } = this.#data.nodes.get(id) ?? {};
    if (!this.nodes.has(id)) this.#add(topicNode(topic, { ...this.#look(id), format }));
    return id;
  }

  #wireConstant(id: string, json: string, targets: NonNullable<NodeRecord['targets']>): void {
    for (const [nodeId, name] of targets) {
      const node = this.nodes.get(nodeId);
      // Another program changed the session: use its value.
      if (node?.kind !== 'module' || node.constants.get(name) !== json) continue;
      const constants = new Map(node.constants);
      constants.delete(name);
      this.nodes.set(nodeId, { ...node, constants });
      this.#connect({ node: id, port: OUT }, { node: nodeId, port: inputPort(name) });
    }
  }

  #add(node: GraphNode): void {
    this.nodes.set(node.id, node);
  }

  #connect(from: PortRef, to: PortRef, via?: string): void {
    const wished = wireId(from, to);
    const points = this.#data.wires.get(wished) ?? [];
    const id = freeKey(this.wires, wished);
    this.wires.set(id, { id, from, to, via, points });
  }

  #look(id: string): NodeRecord | undefined {
    return this.#data.nodes.get(id);
  }
}

/** Bypassed and muted modules, which are only in the editor data, by their ids. */
function standings(session: Session, { modules }: Aside): ReadonlyMap<string, Standing> {
  const ids = new Set(session.processingModules.map(({ id }) => id));
  const resting = modules.filter(({ module }) => module.id !== '' && !ids.has(module.id));
  return new Map(resting.map(({ module, standing }) => [module.id, standing]));
}

/** Appends a number to keys that are taken. */
function freeKey(taken: ReadonlyMap<string, unknown>, wished: string): string {
  let key = wished;
  for (let number = 2; taken.has(key); number += 1) key = `${wished} #${number}`;
  return key;
}

/** Topics that exactly one output writes and some input reads. */
function findWriters(
  modules: readonly MappedModule[],
  hasNode: (topic: string) => boolean,
): ReadonlyMap<string, PortRef> {
  const writers = new Map<string, PortRef[]>();
  const read = new Set<string>();
  for (const { nodeId, inputs, outputs } of modules) {
    for (const { sources } of inputs.values()) {
      for (const source of sources) if (source.kind === 'topic') read.add(source.topic);
    }
    for (const [name, targets] of outputs) {
      for (const target of targets) {
        if (target.kind !== 'topic') continue;
        const from = { node: nodeId, port: outputPort(name) };
        writers.set(target.topic, [...(writers.get(target.topic) ?? []), from]);
      }
    }
  }
  const only = new Map<string, PortRef>();
  for (const [topic, [writer, another]] of writers) {
    if (writer === undefined || another !== undefined) continue;
    if (read.has(topic) && !hasNode(topic)) only.set(topic, writer);
  }
  return only;
}

function editorNode(id: string, record: NodeRecord): GraphNode | undefined {
  const { kind, isLoose, topic, message, json, name = '', text = '', title = '' } = record;
  // Prevent ids of one kind from being used for another.
  if (!id.startsWith(`${kind}:`)) return undefined;
  if (kind === 'comment') return commentNode(id, text, record);
  if (kind === 'frame') return frameNode(id, title, record);
  // Skip constants without a value: an input wired to one would lose its wire.
  if (kind === 'constant') return json ? constantNode(id, json, { ...record, name }) : undefined;
  if (!isLoose) return undefined;
  if (kind === 'topic' && topic !== undefined && id === topicNodeId(topic)) {
    return topicNode(topic, record);
  }
  if (kind === 'muxer') {
    const mux = readMessage('ubii.devices.TopicMux', message);
    return mux && id === muxerNodeId(mux.id) ? muxerNode(mux, record) : undefined;
  }
  if (kind === 'demuxer') {
    const demux = readMessage('ubii.devices.TopicDemux', message);
    return demux && id === demuxerNodeId(demux.id) ? demuxerNode(demux, record) : undefined;
  }
  return undefined;
}

function readMessage<T extends MessageType>(
  type: T,
  json: unknown,
): ReturnType<typeof fromJson<T>> | undefined {
  try {
    return json === undefined ? undefined : fromJson(type, json);
  } catch {
    return undefined;
  }
}
