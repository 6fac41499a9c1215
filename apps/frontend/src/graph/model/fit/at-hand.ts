import type { DataFormat } from '@ubii/proto';
import type { Graph } from '../graph.ts';
import { portFormat } from '../port-format.ts';
import { OUT } from '../ports.ts';
import { wiresOf } from '../wires-of.ts';

/** Formats of the topics without a reader: the next added node probably reads one of them. */
export function formatsAtHand(graph: Graph): ReadonlySet<DataFormat> {
  const formats = new Set<DataFormat>();
  for (const { id, kind } of graph.nodes.values()) {
    if (kind !== 'topic' || wiresOf(graph, id).out.length > 0) continue;
    const format = portFormat(graph, { node: id, port: OUT });
    if (format !== undefined) formats.add(format);
  }
  return formats;
}
