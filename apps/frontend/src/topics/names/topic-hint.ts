/** The published data format, and that of the topic; empty for a topic without a value. */
export interface TopicFormats {
  readonly published: string;
  readonly held: string;
}

/** Returns a warning about an unusual topic; undefined for a usual one. */
export function topicHint(topic: string, { published, held }: TopicFormats): string | undefined {
  if (topic === '') return undefined;
  if (/\s/u.test(topic)) {
    return 'This topic contains spaces. Subscribers have to write it with the same spaces.';
  }
  if (!topic.startsWith('/')) {
    return `Most topics start with a slash. "${topic}" and "/${topic}" are two different topics.`;
  }
  if (topic.includes('*')) {
    return 'This is one topic whose name contains "*". Only subscriptions can use it as a wildcard.';
  }
  if (topic.includes('//') || topic.endsWith('/')) {
    return 'This topic has an empty part between or after its slashes.';
  }
  if (held !== '' && held !== published) {
    return `This topic holds ${held}. Its subscribers may not expect ${published}.`;
  }
  return undefined;
}
