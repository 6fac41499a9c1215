import { expect, it } from 'vitest';
import packageJson from '../../../package.json' with { type: 'json' };
import { LIBRARY_NAME } from './library-name.ts';

it('is the version of the package [EX-25]', () => {
  expect(LIBRARY_NAME).toBe(`client-web/${packageJson.version}`);
});
