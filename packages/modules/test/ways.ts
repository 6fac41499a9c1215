import { createInlineSandboxes } from '@ubii/pm-sandbox/testing';
import { driveDirectly, driveStringified, type Drive } from './drive-module.ts';
import { driveIn } from './drive-sandboxed.ts';

/** Every test of a module runs in each of these ways, for `describe.each`. */
export const WAYS: readonly (readonly [name: string, drive: Drive])[] = [
  ['called directly', driveDirectly],
  ['as text in a bare context', driveStringified],
  ['in a sandbox', driveIn((libraries) => createInlineSandboxes({ libraries }))],
];
