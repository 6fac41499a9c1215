import { ClientState, type Client } from '@ubii/proto';
import { formatLook } from '../formats/families.ts';

/** More sockets than this are not told apart at a glance. */
const MAX_SOCKETS = 6;

/** The formats of a client's components, one of each, publishers first. */
export function clientFormats(client: Pick<Client, 'devices'>): string[] {
  const formats = client.devices
    .flatMap(({ components }) => components)
    .sort((a, b) => a.ioType - b.ioType)
    .map(({ messageFormat }) => formatLook(messageFormat).text)
    .filter((format) => format !== '');
  return [...new Set(formats)].slice(0, MAX_SOCKETS);
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
  if (state === ClientState.INACTIVE) return { text: `silent${since}`, tone: 'warn' };
  if (state === ClientState.UNAVAILABLE) return { text: `away${since}`, tone: 'warn' };
  if (isSelf) return { text: 'this browser', tone: 'plain' };
  if (topics === 0) return { text: 'listens', tone: 'plain' };
  return { text: `${topics} ${topics === 1 ? 'topic' : 'topics'}`, tone: 'plain' };
}
