import { topicParts } from '../../connection/topic-parts.ts';

export type NameOf = (clientId: string) => string | undefined;

/** A topic for people. */
export interface TopicLabel {
  /** The last level, with the client whose id the topic begins with. */
  readonly short: string;
  /** The same with the levels between. */
  readonly long: string;
  /** That client, and what the topic is of a session that ran again; empty for other topics. */
  readonly owner: string;
  /** It is one of a session that ran again. */
  readonly isOfRun: boolean;
}

/** A topic of a session that ran again: an input, or an output, of a recorded topic. [RP-40] */
const OF_RUN = /^\/replays\/[\da-f-]{36}\/(in|out)(.+)$/;

export function topicLabel(topic: string, nameOf: NameOf): TopicLabel {
  const [, direction, recorded = topic] = OF_RUN.exec(topic) ?? [];
  const role = direction === undefined ? '' : direction === 'in' ? 'input' : 'output';
  const { name, place, owner: client } = topicParts(recorded, '', nameOf);
  const owner = [client, role].filter(Boolean).join(', ');
  const isNamed = client !== undefined;
  const end = owner === '' ? '' : ` · ${owner}`;
  const whole = isNamed ? `${place === '' ? name : `${place}/${name}`}` : recorded;
  return {
    short: `${isNamed ? name : recorded}${end}`,
    long: `${whole}${end}`,
    owner,
    isOfRun: role !== '',
  };
}

/** Labels that tell topics apart: short ones, and long ones where those would be the same. */
export function topicLabels(topics: readonly string[], nameOf: NameOf): Map<string, string> {
  const labels = topics.map((topic) => [topic, topicLabel(topic, nameOf)] as const);
  const uses = new Map<string, number>();
  for (const [, { short }] of labels) uses.set(short, (uses.get(short) ?? 0) + 1);
  return new Map(
    labels.map(([topic, { short, long }]) => [topic, uses.get(short) === 1 ? short : long]),
  );
}
