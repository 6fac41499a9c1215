import { ClientState, type Client } from '@ubii/proto';
import { counted } from '@ubii/words';
import { clientKind } from '../../clients/model/client-facts.ts';

/** What is known of a client besides itself. */
export interface HereContext {
  readonly isSelf: boolean;
  /** Modules of running sessions on it. */
  readonly modules: number;
  /** Time since its last activity, formatted; `undefined` when unknown. */
  readonly silence: string | undefined;
}

/** The one fact beside the name of a client. */
export interface HereFact {
  readonly text: string;
  readonly isWarning: boolean;
}

/** Returns what matters most: that it does not answer, that it is this browser, what it runs, or what it is. */
export function hereFact(client: Client, { isSelf, modules, silence }: HereContext): HereFact {
  const since = silence === undefined ? '' : `, ${silence}`;
  const plain = (text: string): HereFact => ({ text, isWarning: false });
  if (client.state === ClientState.INACTIVE)
    return { text: `no response${since}`, isWarning: true };
  if (client.state === ClientState.UNAVAILABLE) return plain(`connection lost${since}`);
  if (isSelf) return plain('this browser');
  return plain(modules > 0 ? `runs ${counted(modules, 'module')}` : clientKind(client));
}
