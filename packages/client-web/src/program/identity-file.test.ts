import { statSync, writeFileSync } from 'node:fs';
import { join } from 'node:path';
import { temporaryFolder } from '@ubii/program/testing';
import { describe, expect, it } from 'vitest';
import { createIdentityFile, defaultIdentityFile } from './identity-file.ts';

function newFile(): string {
  return join(temporaryFolder(), 'nodes', 'identity.json');
}

const ada = { clientId: 'ada', resumeToken: 'secret' };

describe('the identity of a program', () => {
  it('[PM-63] is available in the next run, also after a deregistration', () => {
    const file = newFile();
    expect(createIdentityFile(file).load()).toBeUndefined();
    const first = createIdentityFile(file);
    first.save(ada);
    first.save(undefined);
    expect(createIdentityFile(file).load()).toEqual(ada);
    expect(statSync(file).mode & 0o077).toBe(0);
  });

  it('is not loaded while another process uses it', () => {
    const file = newFile();
    createIdentityFile(file).save(ada);
    const text = JSON.stringify({ ...ada, pid: 1 });
    writeFileSync(file, text);
    const second = createIdentityFile(file, () => true);
    expect(second.load()).toBeUndefined();
    second.save({ clientId: 'ben', resumeToken: undefined });
    expect(createIdentityFile(file, () => false).load()).toEqual(ada);
  });

  it('is undefined when the file is invalid', () => {
    const file = newFile();
    createIdentityFile(file).save(ada);
    for (const text of ['', 'null', '{}', '[1]', '{"clientId":3,"pid":1}']) {
      writeFileSync(file, text);
      expect(createIdentityFile(file).load()).toBeUndefined();
    }
  });

  it('has a file for each name and master', () => {
    const env = { XDG_STATE_HOME: '/state' };
    const file = (master: string, name: string) => defaultIdentityFile('nodes', master, name, env);
    expect(file('http://localhost:8080', 'a/b')).toBe(
      '/state/ubi-interact/nodes/a%2Fb%20at%20localhost%3A8080.json',
    );
    expect(file('http://localhost:8081', 'a/b')).not.toBe(file('http://localhost:8080', 'a/b'));
  });
});
