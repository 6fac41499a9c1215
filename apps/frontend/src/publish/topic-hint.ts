/** What is unusual about a topic that may still be meant; undefined for a usual one. */
export function topicHint(topic: string): string | undefined {
  if (topic === '') return undefined;
  if (/\s/u.test(topic)) {
    return 'This topic contains spaces. Subscribers have to write it with the same spaces.';
  }
  if (!topic.startsWith('/')) {
    return `Most topics start with a slash. "${topic}" and "/${topic}" are two different topics.`;
  }
  if (topic.includes('//') || topic.endsWith('/')) {
    return 'This topic has an empty part between or after its slashes.';
  }
  return undefined;
}
