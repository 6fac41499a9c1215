import { ClientState, type Client, type ClientActivity, type StatusProblem } from '@ubii/proto';
import { describeAgent } from '../../connection/agent-description.ts';
import type { MarkedState } from '../../ui/UiStateMark.vue';
import { clientKind } from './client-facts.ts';

/** Kinds of clients; one client may be of several. */
export type ClientKind = 'phone' | 'browser' | 'node' | 'program';

/** Current data of a client: description, statistics, problems. */
export interface ClientView {
  readonly client: Client;
  /** `undefined` before the first report, and with masters without reports. */
  readonly activity: ClientActivity | undefined;
  /** The master's problems of this client. */
  readonly problems: readonly StatusProblem[];
  readonly isSelf: boolean;
  /** Name, or id when it has none. */
  readonly label: string;
  /** Kind, in a few words. */
  readonly words: string;
  /** Name of its master; empty unless there are several. */
  readonly master: string;
  /** Browser and system, or library, by common names; empty when unknown. */
  readonly agent: string;
  readonly kinds: ReadonlySet<ClientKind>;
  /** True for problems that a user may want to correct. */
  readonly isBroken: boolean;
  /** Status in a word: its problem, otherwise its state. */
  readonly look: ClientStateLook;
}

/** Text and mark for a client's state. */
export interface ClientStateLook {
  readonly mark: MarkedState;
  readonly word: string;
}

const STATES: Record<Client['state'], ClientStateLook> = {
  [ClientState.ACTIVE]: { mark: 'live', word: 'here' },
  [ClientState.INACTIVE]: { mark: 'warning', word: 'silent' },
  [ClientState.UNAVAILABLE]: { mark: 'away', word: 'lost' },
};

export function clientStateLook(state: Client['state']): ClientStateLook {
  return STATES[state] ?? STATES[ClientState.UNAVAILABLE];
}

/** Texts of problems; the first match is shown. */
const TROUBLES: readonly (readonly [code: string, word: string])[] = [
  ['client_silent', 'silent'],
  ['client_slow', 'slow'],
  ['client_throttled', 'throttled'],
  ['publisher_noisy', 'noisy'],
  ['protocol_errors', 'faulty'],
  ['limit_reached', 'at a limit'],
];

function lookOf(client: Client, problems: readonly StatusProblem[]): ClientStateLook {
  const state = clientStateLook(client.state);
  if (client.state !== ClientState.ACTIVE) return state;
  const found = TROUBLES.find(([code]) => problems.some((problem) => problem.code === code));
  if (found) return { mark: 'warning', word: found[1] };
  return problems.length > 0 ? { mark: 'warning', word: 'trouble' } : state;
}

const PHONE = /\b(iPhone|iPad|Android|Mobile|Quest)\b/;

/**
 * @param selfId id of this page
 * @param master name of the client's master; empty unless there are several
 */
export function viewClient(
  client: Client,
  activity: ClientActivity | undefined,
  problems: readonly StatusProblem[],
  selfId: string,
  master = '',
): ClientView {
  const userAgent = activity?.userAgent ?? '';
  const about = problems.filter(({ clientId }) => clientId === client.id);
  const kinds = kindsOf(client, userAgent);
  const agent = agentWords(userAgent, activity?.library ?? '');
  const said = clientKind(client);
  return {
    client,
    activity,
    problems: about,
    isSelf: client.id === selfId,
    label: client.name || client.id,
    words: said === '' ? agent : said,
    master,
    agent,
    kinds,
    isBroken: about.length > 0 || client.state === ClientState.INACTIVE,
    look: lookOf(client, about),
  };
}

function kindsOf(client: Client, userAgent: string): ReadonlySet<ClientKind> {
  const kinds = new Set<ClientKind>();
  const isBrowser = userAgent.startsWith('Mozilla/') || client.tags.includes('browser');
  if (PHONE.test(userAgent) || (isBrowser && PHONE.test(client.description))) kinds.add('phone');
  if (isBrowser) kinds.add('browser');
  const isNode =
    client.isDedicatedProcessingNode ||
    client.processingModules.length > 0 ||
    client.extension?.node !== undefined;
  if (isNode) kinds.add('node');
  if (!isBrowser) kinds.add('program');
  return kinds;
}

/** `Android, Chrome` for a browser, otherwise the library, otherwise the first word of the user agent. */
function agentWords(userAgent: string, library: string): string {
  if (userAgent.startsWith('Mozilla/')) return describeAgent(userAgent);
  return library || (userAgent.split(/[\s(]/, 1)[0] ?? '');
}
