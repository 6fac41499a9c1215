import type { TopicMux } from '@ubii/proto';
import type { DemuxerNode, Graph } from '../model/graph.ts';
import { demuxPreview, type DemuxPreview, type MuxPreview } from '../model/live/mux-preview.ts';
import { wiresOf } from '../model/wires-of.ts';

/** Number of sample topics shown. */
const MAX_SAMPLES = 3;
/** Placeholder for an identity while no element has one. */
const EXAMPLE = 'identity';

/** A demuxer, the topics it would publish on, and their clients. */
export interface DemuxSamples {
  readonly identities: readonly string[];
  readonly preview: DemuxPreview;
  /** Number of further topics that are not shown. */
  readonly more: number;
  /** True when no client is connected and the topics are samples. */
  readonly isExample: boolean;
}

/**
 * Returns the topics that a demuxer would publish on for the elements that the muxers before its module match now.
 * @param previewOf returns the current matches of a muxer
 */
export function demuxSamples(
  graph: Graph,
  node: DemuxerNode,
  previewOf: (mux: TopicMux) => MuxPreview,
): DemuxSamples {
  const found = new Set<string>();
  for (const { from } of wiresOf(graph, node.id).in) {
    for (const wire of wiresOf(graph, from.node).in) {
      const source = graph.nodes.get(wire.from.node);
      if (source?.kind !== 'muxer') continue;
      const preview = previewOf(source.mux);
      if (preview.kind !== 'matches') continue;
      for (const { identity, fits } of preview.matches) if (fits && identity) found.add(identity);
    }
  }
  const isExample = found.size === 0;
  const identities = isExample ? [EXAMPLE] : [...found].slice(0, MAX_SAMPLES);
  const preview = demuxPreview(node.demux, identities);
  return { identities, preview, more: Math.max(0, found.size - identities.length), isExample };
}
