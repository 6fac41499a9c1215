import type { Clock } from '@ubii/timing';
import type { Access } from './access.ts';
import type { TerminalAccess, TerminalJoin } from './terminal-access.ts';
import type { GrantSpec } from './grant.ts';

/** Dependencies of the invitations of a terminal. */
interface TerminalContext {
  readonly access: Access;
  readonly clock: Clock;
}

/** Time for which clients can join with the code in the terminal, milliseconds. [AC-19] */
const TERMINAL_LIFETIME_MS = 12 * 3_600_000;
/**
 * Time after the start for which clients that joined with it can resume, milliseconds: a course of several days.
 * [AC-19]
 */
const TERMINAL_STAY_MS = 7 * 24 * 3_600_000;
/** The token of the operator's machine is good while the master runs, and for no longer than this, milliseconds [AC-42]. */
const OPERATOR_LIFETIME_MS = 365 * 24 * 3_600_000;

/**
 * Makes what the terminal of this run shows, in place of what that of the run before showed.
 *
 * @param isReachable whether others than this machine can reach the master
 */
export async function openTerminal(
  context: TerminalContext,
  isReachable: boolean,
): Promise<TerminalAccess> {
  await context.access.grants.closeTerminals();
  return {
    admin: await openAdmin(context),
    join: isReachable ? await openJoin(context) : undefined,
  };
}

/** Leave for the operator, in the one grant that lasts: browsers that have it stay admins [AC-42]. */
async function openAdmin({ access, clock }: TerminalContext): Promise<TerminalJoin> {
  const { grants } = access;
  const expiresMs = clock.nowMs() + OPERATOR_LIFETIME_MS;
  const before = grants
    .list()
    .find((grant) => grants.isOwnTerminals(grant) && grant.hereOnly && grant.revokedMs === 0);
  const { token, code } =
    before === undefined
      ? await grants.create({
          ...terminalSpec(grants.installation, 'This machine', 'admin', expiresMs),
          hereOnly: true,
        })
      : await grants.renew(before, expiresMs);
  return { token, code, expiresMs };
}

/** Leave for others [AC-19]. */
async function openJoin({ access, clock }: TerminalContext): Promise<TerminalJoin> {
  const expiresMs = clock.nowMs() + TERMINAL_LIFETIME_MS;
  const { installation } = access.grants;
  const spec = terminalSpec(installation, 'Terminal', 'participant', expiresMs);
  const { token, code } = await access.grants.create(spec, clock.nowMs() + TERMINAL_STAY_MS);
  return { token, code, expiresMs };
}

function terminalSpec(
  terminalOf: string,
  label: string,
  role: GrantSpec['role'],
  expiresMs: number,
): GrantSpec {
  return {
    terminalOf,
    label,
    role,
    target: '',
    expiresMs,
    codeExpiresMs: expiresMs,
    maxJoins: 0,
    readTopics: [],
    writeTopics: [],
    isTerminal: true,
    hereOnly: false,
    madeWith: undefined,
  };
}
