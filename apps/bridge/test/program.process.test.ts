import { RunningProgram } from '@ubii/program/testing';
import { expect, it } from 'vitest';
import packageJson from '../package.json' with { type: 'json' };
import { bridgeProgram } from './build-programs.ts';

it('shows its version, and its options', async () => {
  const version = new RunningProgram(bridgeProgram, ['--version']);
  expect(await version.ended()).toBe(0);
  expect(version.stdout).toBe(`${packageJson.version}\n`);
  const help = new RunningProgram(bridgeProgram, ['--help']);
  expect(await help.ended()).toBe(0);
  expect(help.stdout).toContain('--mapping');
});
