/** A topic, all topics that match a glob, or a topic whose records come at most so often. */
export type LivePattern =
  string | { readonly glob: string } | { readonly topic: string; readonly maxRateHz: number };

/** What to subscribe to; `undefined` and the empty topic for nothing. */
export type TopicSource = LivePattern | readonly LivePattern[] | undefined;

/** The patterns of a source. */
export function patternsOf(source: TopicSource): readonly LivePattern[] {
  if (source === undefined || source === '') return [];
  return typeof source === 'object' && 'length' in source ? source : [source];
}

/** What two patterns have in common that select the same topics, whatever their rates. */
export function patternKey(pattern: LivePattern): string {
  if (typeof pattern === 'string') return `topic ${pattern}`;
  return 'glob' in pattern ? `glob ${pattern.glob}` : `topic ${pattern.topic}`;
}

/** The rate limit of one pattern, Hz; `undefined` for that of the subscription as a whole. */
export function patternRateHz(pattern: LivePattern): number | undefined {
  return typeof pattern === 'object' && 'maxRateHz' in pattern ? pattern.maxRateHz : undefined;
}
