import type { SubscribedModule, TopicSubscribers } from '@ubii/proto';

/** How clients are called. */
export interface WatcherNames {
  /** Id of this page's client. */
  readonly selfId: string;
  readonly masterId: string;
  /** Ids of the tabs of this browser. */
  readonly tabIds?: readonly string[];
  /** It has lost its connection, and receives the newest picture when it is back. */
  isAway(clientId: string): boolean;
  nameOf(clientId: string): string;
}

/** Names in the sentence; the others are a number there. */
const MAX_NAMES = 2;

/** Who receives the pictures besides this page, in one sentence. */
export function watcherSentence(subscribers: TopicSubscribers, names: WatcherNames): string {
  const { clientIds, count } = subscribers;
  // Players get a number alone. [EX-96]
  if (clientIds.length === 0) return sentenceOf([], count);
  const isHere = (id: string): boolean => !names.isAway(id);
  const here = watcherNames({ clientIds: clientIds.filter(isHere) }, names);
  // Other tabs of this browser that are away were closed.
  const isLost = (id: string): boolean => names.isAway(id) && !names.tabIds?.includes(id);
  const away = watcherNames({ clientIds: clientIds.filter(isLost) }, names);
  const named = here.length <= MAX_NAMES + 1 ? here : here.slice(0, MAX_NAMES);
  const sentence = sentenceOf(named, here.length - named.length);
  if (away.length === 0) return sentence;
  const who = away.length > MAX_NAMES ? `${away.length} others` : listOf(away);
  const lost = away.length > 1 ? 'have lost their' : 'has lost its';
  return `${sentence} ${capital(who)} ${lost} connection.`;
}

/** Who receives the pictures, except this page, by name; the other tabs of this browser are one. */
export function watcherNames(
  { clientIds }: Pick<TopicSubscribers, 'clientIds'>,
  names: WatcherNames,
): string[] {
  const others = clientIds.filter((id) => id !== names.selfId);
  const isOwn = (id: string): boolean => names.tabIds?.includes(id) ?? false;
  const own = others.filter(isOwn).length;
  const strangers = others.filter((id) => !isOwn(id)).map((id) => placeName(id, names));
  if (own === 0) return strangers;
  return [
    ...strangers,
    own === 1 ? 'another tab of this browser' : `${own} other tabs of this browser`,
  ];
}

/** A module that looks at the pictures, with its session and where it runs. */
export function moduleWords(module: SubscribedModule, names: WatcherNames): string {
  const { name, sessionName, nodeId } = module;
  const session = sessionName === '' ? 'a session without a name' : `“${sessionName}”`;
  if (nodeId === names.selfId) return `${name} of ${session}, in this tab`;
  const place = nodeId === names.masterId ? 'the master' : names.nameOf(nodeId);
  return `${name} of ${session}, on ${place}`;
}

function sentenceOf(names: readonly string[], others: number): string {
  if (names.length + others === 0) return 'No other client receives these pictures.';
  const kind = `${names.length > 0 ? 'other ' : ''}${others === 1 ? 'client' : 'clients'}`;
  const parts = others === 0 ? names : [...names, `${others} ${kind}`];
  const isOne = names.length + others === 1 && !isSeveral(names[0] ?? '');
  const verb = isOne ? 'receives' : 'receive';
  const sentence = `${listOf(parts)} ${verb} these pictures.`;
  return capital(sentence);
}

const isSeveral = (name: string): boolean => /^\d+ other tabs/.test(name);

/** Names of clients are left as they are. */
function capital(sentence: string): string {
  return sentence.replace(
    /^the master|^another tab/,
    (start) => start[0]!.toUpperCase() + start.slice(1),
  );
}

function listOf(parts: readonly string[]): string {
  const before = parts.length > 1 ? `${parts.slice(0, -1).join(', ')} and ` : '';
  return `${before}${parts.at(-1)}`;
}

function placeName(id: string, { masterId, nameOf }: WatcherNames): string {
  return id === masterId ? 'the master' : nameOf(id);
}
