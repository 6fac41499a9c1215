// Set-up of Vitest, before the first file of tests.

export { buildMasterForTests as setup } from './built-master.ts';
