import type { ClientRole, JoinProblem } from '@ubii/client-web';

/** Reason why a client cannot join, and what to do. */
export interface ProblemWords {
  readonly title: string;
  readonly text: string;
}

const PROBLEMS: Record<JoinProblem, ProblemWords> = {
  missing: {
    title: 'Join with the code.',
    text: 'Scan the QR code on the host’s screen with the camera of this phone, or type the code beside it.',
  },
  wrong: {
    title: 'This code is not valid.',
    text: 'Compare it with the host’s screen: a letter may differ, or the host has a new code. After a restart of the master, use its new address or code.',
  },
  expired: {
    title: 'This code has expired.',
    text: 'Ask the host for a new code and scan or type it.',
  },
  revoked: {
    title: 'The host revoked this code.',
    text: 'Ask the host for a new code.',
  },
  used: {
    title: 'This code is used up.',
    text: 'It was valid for a limited number of devices. Ask the host for a new code.',
  },
  guessing: {
    title: 'Too many wrong codes from this network.',
    text: 'This page retries every second. Scanning the QR code works at once.',
  },
  role: {
    title: 'This device has no access to that page.',
    text: 'Its role has no right to open it. Join with a code of another role.',
  },
};

/** The same for users of the master's computer, whose terminal shows a code. [AC-42] */
const PROBLEMS_HERE: Partial<Record<JoinProblem, ProblemWords>> = {
  missing: {
    title: 'Enter the code.',
    text: 'Type the admin code shown in the terminal of the master. This browser becomes an admin.',
  },
  wrong: {
    title: 'This code is not valid.',
    text: 'Compare it with the terminal: a letter may differ, or the master was restarted and shows a new code.',
  },
};

/** @param isHere the page is open on the computer of the master, to become admin */
export function problemWords(problem: JoinProblem, isHere = false): ProblemWords {
  return (isHere ? PROBLEMS_HERE[problem] : undefined) ?? PROBLEMS[problem];
}

/** Label of the button that opens the entry of an admin code. */
export function becomeAdminWords(isHere: boolean): string {
  return isHere
    ? 'Become an admin with the code shown in the terminal'
    : 'Become an admin with an admin code';
}

const ROLES: Record<ClientRole, string> = {
  admin: 'admin',
  participant: 'participant',
  player: 'player',
  viewer: 'viewer',
};

/** Describes a role in one or two sentences. */
export function roleSentence(role: ClientRole): string {
  return {
    admin: 'Role: admin. You can do everything.',
    participant: 'Role: participant. You can use and change sessions and modules.',
    player: 'Role: player. This device publishes its own sensors and topics.',
    viewer: 'Role: viewer. You can see everything and change nothing.',
  }[role];
}

/** Name of a role. */
export function roleWord(role: ClientRole): string {
  return ROLES[role];
}

/** Returns the name of the page that a code opens. */
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
