/** Topic in parts for display. */
export interface TopicParts {
  /** Last part, in which topics of one device differ: `touch_position`. */
  readonly name: string;
  /** Middle part, without client id: `web-interface-smart-device`. */
  readonly place: string;
  /** Name of the client whose id starts the topic. */
  readonly owner: string | undefined;
  /** True for topics of this browser. */
  readonly isOwn: boolean;
}

/** Shortest last level that is meaningful alone; shorter ones are combined: `touch_position/0`. */
const MIN_NAME = 3;

/** @param nameOf returns the name of a client by its id; undefined for unknown ids */
export function topicParts(
  topic: string,
  ownId: string,
  nameOf: (id: string) => string | undefined,
): TopicParts {
  const [first = '', ...rest] = topic.replace(/^\//, '').split('/');
  const isOwn = first === ownId && rest.length > 0;
  const owner = rest.length > 0 ? nameOf(first) : undefined;
  const levels = isOwn || owner !== undefined ? rest : [first, ...rest];
  const taken = levels.length > 1 && levels.at(-1)!.length < MIN_NAME ? 2 : 1;
  const before = levels.slice(0, -taken).join('/');
  const root = levels === rest ? '' : '/';
  return {
    name: before === '' && levels !== rest ? topic : levels.slice(-taken).join('/'),
    place: before === '' ? '' : `${root}${before}`,
    owner,
    isOwn,
  };
}

/** Topics that start with a client id, some without a leading slash. */
const CLIENT_TOPIC = /\/?[\da-f]{8}-[\da-f-]{27}\/[^\s",]+/g;

/** Replaces client topics in a text. */
export function replaceClientTopics(words: string, nameTopic: (topic: string) => string): string {
  return words.replace(CLIENT_TOPIC, (topic) => nameTopic(topic));
}
