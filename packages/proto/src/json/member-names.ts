/** Messages with a mapping, and the names of the oneof that older applications put a topic into. */
const LEGACY_MAPPINGS: {
  readonly [messageType: string]: {
    readonly oneof: readonly string[];
    readonly members: readonly string[];
  };
} = {
  'ubii.sessions.TopicInputMapping': {
    oneof: ['topicSource', 'topic_source'],
    members: ['topic', 'topicMux', 'topic_mux'],
  },
  'ubii.sessions.TopicOutputMapping': {
    oneof: ['topicDestination', 'topic_destination'],
    members: ['topic', 'topicDemux', 'topic_demux'],
  },
};

/**
 * Older applications write `{inputName, topicSource: '/a/topic'}` instead of `{inputName, topic:
 * '/a/topic'}`. Newer ones write the name of the set member there (`topicSource: 'topic'`), as
 * protobufjs does: that says nothing and is ignored. [SV-3]
 *
 * @returns the same object, or one with the topic where it belongs
 */
export function withoutLegacyMapping(messageType: string, json: object): object {
  const mapping = LEGACY_MAPPINGS[messageType];
  if (mapping === undefined) return json;
  const members = json as Readonly<Record<string, unknown>>;
  const isGiven = (key: string): boolean => {
    const value = Object.hasOwn(members, key) ? members[key] : undefined;
    return value !== undefined && value !== null && value !== '';
  };
  if (mapping.members.some(isGiven)) return json;
  const key = mapping.oneof.find(isGiven);
  const topic = key === undefined ? undefined : members[key];
  if (typeof topic !== 'string' || mapping.members.includes(topic)) return json;
  return { ...members, topic };
}

/** Names with more wrong letters are another name, not a misspelt one. */
const MAX_WRONG_LETTERS = 2;

/**
 * Returns the name that a misspelt one most likely means: the one with the fewest wrong, missing or
 * surplus letters, at most two and fewer than half of its own; upper and lower case are the same.
 */
export function similarName(misspelt: string, names: readonly string[]): string | undefined {
  let best: string | undefined;
  let fewest = MAX_WRONG_LETTERS + 1;
  for (const name of names) {
    if (Math.abs(name.length - misspelt.length) >= fewest) continue;
    const wrong = distance(misspelt.toLowerCase(), name.toLowerCase());
    if (wrong >= fewest || wrong * 2 >= name.length) continue;
    best = name;
    fewest = wrong;
  }
  return best;
}

/** Levenshtein distance: the fewest insertions, deletions and replacements that turn `a` into `b`. */
function distance(a: string, b: string): number {
  let row = Array.from({ length: b.length + 1 }, (_, index) => index);
  for (let i = 1; i <= a.length; i += 1) {
    const next = [i];
    for (let j = 1; j <= b.length; j += 1) {
      const replaced = row[j - 1]! + (a[i - 1] === b[j - 1] ? 0 : 1);
      next.push(Math.min(replaced, row[j]! + 1, next[j - 1]! + 1));
    }
    row = next;
  }
  return row[b.length]!;
}
