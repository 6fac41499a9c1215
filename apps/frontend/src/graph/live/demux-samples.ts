import type { TopicMux } from '@ubii/proto';
import type { DemuxerNode, Graph } from '../model/graph.ts';
import { demuxPreview, type DemuxPreview, type MuxPreview } from '../model/live/mux-preview.ts';
import { wiresOf } from '../model/wires-of.ts';

/** Sample topics shown. */
const MAX_SAMPLES = 3;
/** Stands for an identity when nothing gives one yet. */
const EXAMPLE = 'identity';

/** A demuxer with topics it would publish on, and for whom. */
export interface DemuxSamples {
  readonly identities: readonly string[];
  readonly preview: DemuxPreview;
  /** More would be published on than are shown. */
  readonly more: number;
  /** No client is connected now; the topics are samples. */
  readonly isExample: boolean;
}

/**
 * Topics a demuxer would publish on, for what the muxers of the modules before it gather now.
 * @param previewOf what a muxer gathers
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
