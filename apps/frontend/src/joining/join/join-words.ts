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
    text: 'Compare it with the host’s screen: a letter may differ, or the host has a new code. After a restart, the host shows a new address or code.',
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
    title: 'This code does not open that page.',
    text: 'Join with a code that allows it, or ask the host.',
  },
};

/** The same for users of the master's computer, whose terminal shows a code. [AC-42] */
const PROBLEMS_HERE: Partial<Record<JoinProblem, ProblemWords>> = {
  missing: {
    title: 'Enter the code.',
    text: 'Type the code shown in the terminal where Ubi-Interact runs. With it, this browser may do everything.',
  },
  wrong: {
    title: 'This code is not valid.',
    text: 'Compare it with the terminal: a letter may differ, or Ubi-Interact was restarted and shows a new code.',
  },
};

/** @param isHere the page is open on the computer of the master, to become admin */
export function problemWords(problem: JoinProblem, isHere = false): ProblemWords {
  return (isHere ? PROBLEMS_HERE[problem] : undefined) ?? PROBLEMS[problem];
}

/** Label of the button that opens the entry of a code that makes an admin. */
export function becomeAdminWords(isHere: boolean): string {
  return isHere ? 'Enter the code shown in the terminal' : 'Enter a code of the host';
}

const MAY: Record<ClientRole, string> = {
  admin: 'May do everything.',
  participant: 'May use and change everything except codes and other clients.',
  player: 'Sends what is done on it, and changes nothing else.',
  viewer: 'Sees everything and changes nothing.',
};

/** What devices send from the pages on which they are one. */
const SENT: Readonly<Record<string, string>> = {
  '/devices/smart-device': 'touch and motion',
  '/devices/controller': 'buttons and sticks',
  '/devices/camera': 'pictures from the camera',
};

/** What joining sends, in one sentence. @param host how the host is called */
export function sendsSentence(role: ClientRole, target: string, host: string): string {
  if (role === 'viewer') return `Sends nothing. You see what happens at ${host}.`;
  const sent = SENT[target.split(/[?#]/, 1)[0] ?? ''] ?? 'what you do here';
  return `Sends ${sent} to ${host} until you leave.`;
}

/** What a browser with a role may do, one sentence. */
export function maySentence(role: ClientRole): string {
  return MAY[role];
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
