import { isMasterTopic } from '@ubii/proto';
import { fillPath, matchPath } from './address-path.ts';
import { givesOut, takesIn } from './mapping.ts';
import type { Mapping } from './mapping.ts';

/** Matches of each direction that are listed. */
const SHOWN = 25;

/** What there is at both sides. */
export interface Present {
  readonly topics: readonly string[];
  readonly addresses: readonly string[];
}

/** What a mapping makes of a topic or an address. */
export interface PreviewedMatch {
  /** From an address of the other system to a topic. */
  readonly inward: boolean;
  readonly source: string;
  readonly target: string;
}

/** What a mapping selects of what there is, and what it makes of it. [BR-81] */
export function previewMapping(
  mapping: Mapping,
  { topics, addresses }: Present,
): { readonly matches: readonly PreviewedMatch[]; readonly more: number } {
  const matches: PreviewedMatch[] = [];
  let more = 0;
  const add = (inward: boolean, sources: readonly string[]): void => {
    const from = inward ? mapping.foreign : mapping.topic;
    const to = inward ? mapping.topic : mapping.foreign;
    let shown = 0;
    for (const source of sources) {
      const captures = matchPath(from, source);
      if (captures === undefined) continue;
      if (shown++ < SHOWN) matches.push({ inward, source, target: fillPath(to, captures) });
      else more++;
    }
  };
  if (takesIn(mapping)) add(true, [...addresses].sort());
  if (givesOut(mapping)) add(false, topics.filter((topic) => !isMasterTopic(topic)).sort());
  return { matches, more };
}
