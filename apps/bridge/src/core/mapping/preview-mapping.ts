import { isMasterTopic } from '@ubii/proto';
import { exampleOf, fillPath, matchPath } from './address-path.ts';
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
  /** Made up, because nothing that is there matches. */
  readonly isExample: boolean;
}

/** What a mapping selects of what there is, and what it makes of it; where it selects nothing, of an example. [BR-81] */
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
      const match = { inward, source, target: fillPath(to, captures), isExample: false };
      if (shown++ < SHOWN) matches.push(match);
      else more++;
    }
    if (shown > 0) return;
    const captures = exampleOf(from);
    const [source, target] = [fillPath(from, captures), fillPath(to, captures)];
    matches.push({ inward, source, target, isExample: true });
  };
  if (takesIn(mapping)) add(true, [...addresses].sort());
  if (givesOut(mapping)) add(false, topics.filter((topic) => !isMasterTopic(topic)).sort());
  return { matches, more };
}
