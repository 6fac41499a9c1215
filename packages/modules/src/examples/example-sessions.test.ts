import { readdirSync, readFileSync } from 'node:fs';
import { fromJson, toJson } from '@ubii/proto';
import { describe, expect, it } from 'vitest';
import { sessionFile } from '../../scripts/session-file.ts';
import { expectKnownNames } from '../../test/known-names.ts';
import { EXAMPLE_SESSIONS } from './example-sessions.ts';

const FORMAT = 'ubii.sessions.Session';
const FOLDER = `${import.meta.dirname}/../../sessions`;

describe('the example sessions', () => {
  it('are the files in the folder', () => {
    const names = Object.keys(EXAMPLE_SESSIONS).map((id) => `${id}.session`);
    expect(readdirSync(FOLDER).sort()).toEqual(names.sort());
  });

  it.each(Object.entries(EXAMPLE_SESSIONS))('have %s in its file, complete', (id, session) => {
    const text = readFileSync(`${FOLDER}/${id}.session`, 'utf8');
    expect(text, 'run pnpm --filter @ubii/modules generate').toBe(sessionFile(session));
    const read = fromJson(FORMAT, JSON.parse(text));
    expect(read).toEqual(fromJson(FORMAT, toJson(FORMAT, session)));
    expect(read.name).toMatch(/^[A-Z]/);
    expectKnownNames(read);
  });
});
