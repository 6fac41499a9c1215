import type { ClientRole, JoinProblem } from '@ubii/client-web';

/** Why somebody is not let in: what happened, and the way out. */
export interface ProblemWords {
  readonly title: string;
  readonly text: string;
}

const PROBLEMS: Record<JoinProblem, ProblemWords> = {
  missing: {
    title: 'Join with the code.',
    text: 'Scan the QR code on the host’s screen with the camera of this phone, or type the code that stands beside it.',
  },
  wrong: {
    title: 'That code is not known here.',
    text: 'Look at the host’s screen again: a letter may be different, or a new code was made since.',
  },
  expired: {
    title: 'That code is no longer valid.',
    text: 'Its time is over. Ask the host for a new one and scan or type that.',
  },
  revoked: {
    title: 'The host has closed this code.',
    text: 'Nobody can join with it any more. Ask the host for a new one.',
  },
  used: {
    title: 'Everybody has joined who may.',
    text: 'This code was for a limited number of devices. Ask the host for another.',
  },
  guessing: {
    title: 'Too many wrong codes from this network.',
    text: 'This page asks again every second; scanning the QR code works at once.',
  },
  role: {
    title: 'This device may not open that page.',
    text: 'It joined with a code that allows less. A code with another role lets it in.',
  },
};

/** The same for somebody at the master's own machine, whose terminal shows a code. [AC-42] */
const PROBLEMS_HERE: Partial<Record<JoinProblem, ProblemWords>> = {
  missing: {
    title: 'Enter the code.',
    text: 'The terminal that the master was started in shows it as the code for admins. It makes this browser an admin.',
  },
  wrong: {
    title: 'That code is not known here.',
    text: 'Look at the terminal again: a letter may be different, or the master was started anew and shows another code.',
  },
};

/** @param isHere somebody wants to become admin, on the master's own machine */
export function problemWords(problem: JoinProblem, isHere = false): ProblemWords {
  return (isHere ? PROBLEMS_HERE[problem] : undefined) ?? PROBLEMS[problem];
}

/** What a button says that leads to where an admin's code is entered. */
export function becomeAdminWords(isHere: boolean): string {
  return isHere ? 'Enter the code shown in the terminal' : 'Enter a code for admins';
}

const ROLES: Record<ClientRole, string> = {
  admin: 'admin',
  participant: 'participant',
  player: 'player',
  viewer: 'viewer',
};

/** What joining gives, in a few words. */
export function roleSentence(role: ClientRole): string {
  return {
    admin: 'You join as admin: you may do everything.',
    participant: 'You join as participant: you may use and change sessions and modules.',
    player: 'You join as player: this device takes part with its own sensors and topics.',
    viewer: 'You join as viewer: you see everything and change nothing.',
  }[role];
}

/** The role in one word. */
export function roleWord(role: ClientRole): string {
  return ROLES[role];
}

/** Names of pages that people are sent to. */
export function targetWord(path: string): string {
  const known: Record<string, string> = {
    '/': 'home',
    '/devices': 'devices',
    '/topics': 'topics',
    '/examples': 'examples',
  };
  const word = known[path] ?? path.split(/[?#]/, 1)[0]!.split('/').at(-1) ?? '';
  return word.replaceAll('-', ' ');
}
