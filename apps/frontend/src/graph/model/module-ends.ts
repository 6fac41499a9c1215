import type { Graph, ModuleNode, PortRef } from './graph.ts';
import { ioName } from './ports.ts';
import { endKey, type InputEnds, type InputSource, type OutputTarget } from './read-mappings.ts';
import { wiresOf } from './wires-of.ts';

/** Mappings of a module. */
export interface ModuleEnds {
  readonly inputs: ReadonlyMap<string, InputEnds>;
  readonly outputs: ReadonlyMap<string, readonly OutputTarget[]>;
}

/** Returns the mappings that the wires of a module represent. */
export function moduleEnds(graph: Graph, node: ModuleNode): ModuleEnds {
  const wires = wiresOf(graph, node.id);
  const inputs = new Map<string, { sources: InputSource[]; constantJson: string }>();
  const inputAt = (name: string): { sources: InputSource[]; constantJson: string } => {
    let ends = inputs.get(name);
    if (ends === undefined) inputs.set(name, (ends = { sources: [], constantJson: '' }));
    return ends;
  };
  for (const [name, json] of node.constants) inputAt(name).constantJson = json;
  for (const { from, to, via } of wires.in) {
    const ends = inputAt(ioName(to.port));
    const source = graph.nodes.get(from.node);
    if (via !== undefined) ends.sources.push({ kind: 'topic', topic: via });
    else if (source?.kind === 'topic') ends.sources.push({ kind: 'topic', topic: source.topic });
    else if (source?.kind === 'muxer') ends.sources.push({ kind: 'muxer', mux: source.mux });
    else if (source?.kind === 'constant') ends.constantJson = source.json;
  }
  const outputs = new Map<string, Map<string, OutputTarget>>();
  for (const { from, to, via, id } of wires.out) {
    const target = targetAt(graph, to, via);
    if (target === undefined) continue;
    const name = ioName(from.port);
    const targets = outputs.get(name) ?? new Map<string, OutputTarget>();
    outputs.set(name, targets);
    // Wires to several modules share one topic; two wires to one topic are two mappings.
    targets.set(via === undefined ? id : endKey(target), target);
  }
  return {
    inputs,
    outputs: new Map([...outputs].map(([name, targets]) => [name, [...targets.values()]])),
  };
}

function targetAt(graph: Graph, to: PortRef, via: string | undefined): OutputTarget | undefined {
  if (via !== undefined) return { kind: 'topic', topic: via };
  const node = graph.nodes.get(to.node);
  if (node?.kind === 'topic') return { kind: 'topic', topic: node.topic };
  return node?.kind === 'demuxer' ? { kind: 'demuxer', demux: node.demux } : undefined;
}
