/** A topic in parts that people tell topics apart by. */
export interface TopicParts {
  /** Its end, in which topics of one device differ: `touch_position`. */
  readonly name: string;
  /** What is before the end, without the id of a client: `web-interface-smart-device`. */
  readonly place: string;
  /** Name of the client whose id the topic begins with. */
  readonly owner: string | undefined;
  /** It is a topic of this browser. */
  readonly isOwn: boolean;
}

/** An end as short as this says nothing alone: `touch_position/0`. */
const MIN_NAME = 3;

/** @param nameOf returns the name of a client by its id, undefined when there is no such client */
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

/** Topics that begin with the id of a client; some have no slash in front. */
const CLIENT_TOPIC = /\/?[\da-f]{8}-[\da-f-]{27}\/[^\s",]+/g;

/** Replaces topics of clients in a sentence. */
export function replaceClientTopics(words: string, nameTopic: (topic: string) => string): string {
  return words.replace(CLIENT_TOPIC, (topic) => nameTopic(topic));
}
