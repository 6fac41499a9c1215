import {
  checkJoining,
  identityOption,
  JOINING_OPTIONS,
  nameOption,
  printEndpointsOption,
} from '@ubii/client-program';
import {
  HELP_OPTIONS,
  listOption,
  logLevelOption,
  option,
  parseFetchOrigins,
  parseWholeNumber,
  pathOption,
  switchOption,
} from '@ubii/program';
import type { OptionValues, ProgramOptions } from '@ubii/program';

/** Room for a few modules. */
const MIN_MEGABYTES = 8;

/** Every option. */
export const OPTIONS = {
  ...JOINING_OPTIONS,
  modules: pathOption(
    '<folder>',
    'none',
    'Folder with modules of your own, as .pm, .js and .mjs files. Their code is trusted. Changes apply at once.',
  ),
  name: nameOption('node'),
  allowFetch: listOption(
    '<origin>,...',
    'Origins that modules may read from with the library http, such as https://example.org,http://sensor.local:8000.',
    parseFetchOrigins,
  ),
  noAcceptWork: switchOption(
    'Run only modules that a session assigns to this node by name. The master does not choose this node.',
  ),
  capacity: option({
    placeholder: '<number>',
    fallback: 0,
    fallbackText: 'none',
    description:
      'Number of modules this node should run at once. The master uses it to choose a node.',
    parse: parseWholeNumber(0, 99_999),
  }),
  memory: option({
    placeholder: '<MiB>',
    fallback: 0,
    fallbackText: "a quarter of the machine's memory, at least 256",
    description:
      'Memory of all sandboxed modules on this node, in MiB. Modules of one session get half of it, at most 1024.',
    parse: parseMegabytes,
  }),
  recordDir: pathOption(
    '<folder>',
    'off',
    'Record for the master into this folder, when a client starts a recording there. Recordings are uploaded to the master when they end; the node joins as a participant or an admin for that.',
  ),
  recordSpace: option({
    placeholder: '<MiB>',
    fallback: 20_480 * 1024 * 1024,
    fallbackText: '20480',
    description: 'Most space of recordings in the folder, in MiB; recordings stop beyond it.',
    parse: parseMegabytes,
  }),
  identity: identityOption,
  printEndpoints: printEndpointsOption,
  logLevel: logLevelOption,
  ...HELP_OPTIONS,
} as const;

/** The values of all options. */
export type Config = OptionValues<typeof OPTIONS>;

/** The options and where they are read from. */
export const NODE_PROGRAM: ProgramOptions<typeof OPTIONS> = {
  options: OPTIONS,
  environmentPrefix: 'UBII_NODE_',
  about: `Ubi-Interact node: runs processing modules of the sessions of a master.

  npm run node -- [flags]

Each option is a flag and an environment variable. When both are set, the flag applies.
`,
  check: checkJoining,
};

/** @returns bytes */
function parseMegabytes(text: string): number {
  const megabytes = /^\d{1,6}$/.test(text) ? Number(text) : 0;
  if (megabytes < MIN_MEGABYTES) throw new Error(`a whole number of MiB from ${MIN_MEGABYTES}`);
  return megabytes * 1024 * 1024;
}
