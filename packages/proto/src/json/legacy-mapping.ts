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
