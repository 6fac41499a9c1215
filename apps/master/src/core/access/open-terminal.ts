import type { Core } from '../core.ts';
import type { TerminalJoin } from '../master.ts';

/** How long somebody can join with what a terminal shows, milliseconds [AC-19]. */
const TERMINAL_LIFETIME_MS = 12 * 3_600_000;

/** Makes the leave to join for the terminal of this run, in place of that of the run before [AC-19]. */
export async function openTerminal({ access, clock }: Core): Promise<TerminalJoin> {
  await access.grants.closeTerminals();
  const expiresMs = clock.nowMs() + TERMINAL_LIFETIME_MS;
  const { token, code } = await access.grants.create({
    label: 'Terminal',
    role: 'participant',
    target: '',
    expiresMs,
    codeExpiresMs: expiresMs,
    maxJoins: 0,
    readTopics: [],
    writeTopics: [],
    isTerminal: true,
  });
  return { token, code, expiresMs };
}
