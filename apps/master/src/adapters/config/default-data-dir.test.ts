import { describe, expect, it } from 'vitest';

import { defaultDataDir } from './default-data-dir.ts';

describe('the default data directory', () => {
  it.each([
    ['linux', {}, '/home/ada/.local/share/ubi-interact'],
    ['linux', { XDG_DATA_HOME: '/data' }, '/data/ubi-interact'],
    ['linux', { XDG_DATA_HOME: '' }, '/home/ada/.local/share/ubi-interact'],
    ['darwin', {}, '/home/ada/Library/Application Support/ubi-interact'],
  ])('%s %j', (platform, env, expected) => {
    expect(defaultDataDir(env, platform, '/home/ada')).toBe(expected);
  });
});
