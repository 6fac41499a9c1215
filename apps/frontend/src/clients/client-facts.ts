import {
  ClientState,
  StatusEventKind,
  type Client,
  type StatusEvent,
  type StatusProblem,
} from '@ubii/proto';
import { counted } from '@ubii/words';
import { formatLook } from '../formats/families.ts';

/** Most sockets shown; more cannot be distinguished at a glance. */
const MAX_SOCKETS = 6;

/** Socket for the data formats of a client with the same shape and colour. */
export interface ClientSocket {
  /** One of the formats. */
  readonly format: string;
  /** Names of all its formats. */
  readonly names: string;
}

/** Sockets of a client's components, one per shape, publishers first. */
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
 * Returns the time since which a client is away, epoch milliseconds of the master's clock; `undefined` when it is
 * present or the time is unknown.
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

/** Kind of a client in a few words: from its own description, otherwise from its properties. */
export function clientKind(client: Client): string {
  const words = client.description.trim() || client.tags.join(', ');
  if (words !== '') return words;
  return client.isDedicatedProcessingNode ? 'runs modules' : '';
}

export type ClientNote = { readonly text: string; readonly tone: 'plain' | 'warn' };

/**
 * Note at the end of a client's row.
 * @param silence formatted duration: `38 s`; `undefined` when unknown
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
