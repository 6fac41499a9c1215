import firstModule from '@ubii/client-web/samples/first-module.mjs?raw';
import firstPage from '@ubii/client-web/samples/first-page.html?raw';
import firstProgram from '@ubii/client-web/samples/first-program.mjs?raw';

/** What one writes: the sample, and what the master sees of it. */
export interface ProgramKind {
  readonly title: string;
  readonly hint: string;
  readonly file: string;
  readonly sample: string;
  /** Name of its client. */
  readonly clientName: string;
  /** Topic that it publishes. */
  readonly topic?: string;
  /** Topic of a lamp that it reads. */
  readonly lamp?: string;
  /** It runs in a browser, without an installation. */
  readonly isPage: boolean;
}

const LAMP = '/first-program/lamp';

/** The samples of the client library. */
export const PROGRAM_KINDS = {
  program: {
    title: 'A program in Node',
    hint: 'JavaScript, Node 20.19 or newer',
    file: 'first-program.mjs',
    sample: firstProgram,
    clientName: 'first program',
    topic: '/first-program/wave',
    lamp: LAMP,
    isPage: false,
  },
  module: {
    title: 'A module in Node',
    hint: 'Runs in your program, in any session',
    file: 'first-module.mjs',
    sample: firstModule,
    clientName: 'first module',
    isPage: false,
  },
  page: {
    title: 'A page',
    hint: 'HTML in any browser, without a build',
    file: 'first-page.html',
    sample: firstPage,
    clientName: 'first page',
    lamp: LAMP,
    isPage: true,
  },
} as const satisfies Record<string, ProgramKind>;

export type ProgramKindName = keyof typeof PROGRAM_KINDS;
