import {
  ClientState,
  StatusEventKind,
  type Client,
  type StatusEvent,
  type StatusProblem,
} from '@ubii/proto';
import { counted } from '@ubii/words';
import { formatLook } from '../formats/families.ts';

/** More sockets than this are not distinguished at a glance. */
const MAX_SOCKETS = 6;

/** One socket for the data formats of a client that look alike. */
export interface ClientSocket {
  /** One of the formats, for shape and colour. */
  readonly format: string;
  /** All of them by name. */
  readonly names: string;
}

/** The sockets of a client's components, one of each shape, publishers first. */
export function clientSockets(client: Pick<Client, 'devices'>): ClientSocket[] {
  const names = new Map<string, string[]>();
  const components = client.devices.flatMap((device) => device.components);
  for (const { messageFormat } of components.sort((a, b) => a.ioType - b.ioType)) {
    if (messageFormat === '') continue;
    const { family, isList, text } = formatLook(messageFormat);
    const shape = `${family} ${isList}`;
    const alike = names.get(shape) ?? [];
    if (!alike.includes(text)) names.set(shape, [...alike, text]);
  }
  return [...names.values()]
    .slice(0, MAX_SOCKETS)
    .map((alike) => ({ format: alike[0]!, names: alike.join(', ') }));
}

/**
 * Since when a client is away, the master's clock, epoch milliseconds; `undefined` when it is here or
 * it is unknown.
 * @param events oldest first
 */
export function awaySinceMs(
  clientId: string,
  problems: readonly StatusProblem[],
  events: readonly StatusEvent[],
): number | undefined {
  const problem = problems.find(
    (candidate) => candidate.code === 'client_silent' && candidate.clientId === clientId,
  );
  if (problem) return problem.sinceMs;
  const lost = events.findLast((event) => event.clientId === clientId);
  return lost?.kind === StatusEventKind.CLIENT_LOST ? lost.timeMs : undefined;
}

/** What a client is, in a few words: what it says of itself, else what can be seen. */
export function clientKind(client: Client): string {
  const words = client.description.trim() || client.tags.join(', ');
  if (words !== '') return words;
  return client.isDedicatedProcessingNode ? 'runs modules' : '';
}

export type ClientNote = { readonly text: string; readonly tone: 'plain' | 'warn' };

/**
 * The words at the end of a client's row.
 * @param silence for how long, as shown: `38 s`; `undefined` when unknown
 */
export function clientNote(
  state: Client['state'],
  isSelf: boolean,
  topics: number,
  silence: string | undefined,
): ClientNote {
  const since = silence === undefined ? '' : `, ${silence}`;
  if (state === ClientState.INACTIVE) return { text: `no response${since}`, tone: 'warn' };
  if (state === ClientState.UNAVAILABLE) return { text: `connection lost${since}`, tone: 'plain' };
  if (isSelf) return { text: 'this browser', tone: 'plain' };
  if (topics === 0) return { text: 'publishes nothing', tone: 'plain' };
  return { text: counted(topics, 'topic'), tone: 'plain' };
}
