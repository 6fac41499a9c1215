import { describe, expect, it } from 'vitest';

import { userDataFolder } from './program-files.ts';

describe('the folder for data of a user', () => {
  it.each([
    ['linux', {}, '/home/ada/.local/share/ubi-interact'],
    ['linux', { XDG_DATA_HOME: '/data' }, '/data/ubi-interact'],
    ['linux', { XDG_DATA_HOME: '' }, '/home/ada/.local/share/ubi-interact'],
    ['darwin', {}, '/home/ada/Library/Application Support/ubi-interact'],
  ])('%s %j', (platform, env, expected) => {
    expect(userDataFolder(env, platform, '/home/ada')).toBe(expected);
  });
});
