// `globalSetup` of Vitest, before the first test file.

export { buildMasterForTests as setup } from './built-programs.ts';
