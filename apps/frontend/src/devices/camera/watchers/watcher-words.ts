import type { SubscribedModule, TopicSubscribers } from '@ubii/proto';
import { capitalised, plural } from '@ubii/words';

/** Names of clients. */
export interface WatcherNames {
  /** Id of this page's client. */
  readonly selfId: string;
  readonly masterId: string;
  /** Ids of this browser's tabs. */
  readonly tabIds?: readonly string[];
  nameOf(clientId: string): string;
}

/** Most names in the sentence; further receivers are counted. */
const MAX_NAMES = 2;

/** Receivers of the pictures besides this page, in one sentence. */
export function watcherSentence(subscribers: TopicSubscribers, names: WatcherNames): string {
  const { clientIds, count } = subscribers;
  // Players receive only the number. [EX-96]
  if (clientIds.length === 0) return sentenceOf([], count);
  const others = watcherNames(subscribers, names);
  const named = others.length <= MAX_NAMES + 1 ? others : others.slice(0, MAX_NAMES);
  const left = others.slice(named.length).reduce((sum, one) => sum + countOf(one), 0);
  return sentenceOf(named, left);
}

/** Names of the receivers except this page; other tabs of this browser count as one. */
export function watcherNames({ clientIds }: TopicSubscribers, names: WatcherNames): string[] {
  const others = clientIds.filter((id) => id !== names.selfId);
  const isOwn = (id: string): boolean => names.tabIds?.includes(id) ?? false;
  const own = others.filter(isOwn).length;
  const strangers = others.filter((id) => !isOwn(id)).map((id) => placeName(id, names));
  if (own === 0) return strangers;
  return [
    ...strangers,
    plural(own, 'another tab of this browser', `${own} other tabs of this browser`),
  ];
}

/** Describes a module that reads the pictures, with its session and node. */
export function moduleWords(module: SubscribedModule, names: WatcherNames): string {
  const { name, sessionName, nodeId } = module;
  const session = sessionName === '' ? 'a session without a name' : `“${sessionName}”`;
  if (nodeId === names.selfId) return `${name} of ${session}, in this tab`;
  const place = nodeId === names.masterId ? 'the master' : names.nameOf(nodeId);
  return `${name} of ${session}, on ${place}`;
}

function sentenceOf(names: readonly string[], others: number): string {
  if (names.length + others === 0) return 'No other client receives these pictures.';
  const kind = `${names.length > 0 ? 'other ' : ''}${plural(others, 'client')}`;
  const parts = others === 0 ? names : [...names, `${others} ${kind}`];
  const isOne = names.reduce((sum, one) => sum + countOf(one), others) === 1;
  const verb = isOne ? 'receives' : 'receive';
  const sentence = `${listOf(parts)} ${verb} these pictures.`;
  // Client names keep their case.
  return sentence.replace(/^the master|^another tab/, capitalised);
}

const countOf = (name: string): number => Number(/^(\d+) other tabs/.exec(name)?.[1] ?? 1);

function listOf(parts: readonly string[]): string {
  const before = parts.length > 1 ? `${parts.slice(0, -1).join(', ')} and ` : '';
  return `${before}${parts.at(-1)}`;
}

function placeName(id: string, { masterId, nameOf }: WatcherNames): string {
  return id === masterId ? 'the master' : nameOf(id);
}
