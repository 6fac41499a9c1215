/** A topic, a glob, or one of these with a rate limit. */
export type LivePattern =
  | string
  | { readonly glob: string }
  | { readonly topic: string; readonly maxRateHz: number };

/** Topics to subscribe to; `undefined` and the empty topic for none. */
export type TopicSource = LivePattern | readonly LivePattern[] | undefined;

/** The patterns of a source. */
export function patternsOf(source: TopicSource): readonly LivePattern[] {
  if (source === undefined || source === '') return [];
  return typeof source === 'object' && 'length' in source ? source : [source];
}

/** Key of a pattern: equal for patterns that match the same topics, whatever their rates. */
export function patternKey(pattern: LivePattern): string {
  if (typeof pattern === 'string') return `topic ${pattern}`;
  return 'glob' in pattern ? `glob ${pattern.glob}` : `topic ${pattern.topic}`;
}

/** Rate limit of a pattern, Hz; `undefined`: that of the subscription. */
export function patternRateHz(pattern: LivePattern): number | undefined {
  return typeof pattern === 'object' && 'maxRateHz' in pattern ? pattern.maxRateHz : undefined;
}
