import { describe, expect, it } from 'vitest';
import { matchesProfile, selectByProfiles } from './profiles.ts';

const phone = {
  id: 'phone-1',
  name: 'phone',
  clientId: 'ada',
  tags: ['smart device', 'red'],
  components: [
    { id: 'c1', messageFormat: 'vector2', ioType: 0, tags: ['touch'] },
    { id: 'c2', messageFormat: 'vector2', ioType: 0, tags: ['touch', 'second'] },
    { id: 'c3', messageFormat: 'vector3', ioType: 1, tags: ['orientation'] },
  ],
};

describe('matchesProfile', () => {
  it.each([
    [{}],
    [{ id: '', name: '', tags: [], components: [] }],
    [{ id: 'phone-1' }],
    [{ name: 'phone', clientId: 'ada' }],
    [{ tags: ['red'] }],
    [{ tags: ['red', 'smart device'] }],
    [{ components: [{ tags: ['touch'] }] }],
    [{ components: [{ tags: ['touch'] }, { tags: ['orientation'] }] }],
    [{ components: [{ messageFormat: 'vector3', ioType: 1 }] }],
    [{ components: [{ messageFormat: 'vector2', ioType: 0 }] }],
  ])('meets %j [CL-20]', (profile) => {
    expect(matchesProfile(phone, profile)).toBe(true);
  });

  it.each([
    [{ id: 'phone' }],
    [{ name: 'phone', clientId: 'ben' }],
    [{ tags: ['red', 'green'] }],
    [{ components: [{ tags: ['touch', 'orientation'] }] }],
    [{ components: [{ tags: ['touch'] }, { tags: ['gyroscope'] }] }],
    [{ components: [{ messageFormat: 'vector2', ioType: 1 }] }],
    [{ processingModules: [{ name: 'mirror' }] }],
  ])('does not meet %j [CL-20]', (profile) => {
    expect(matchesProfile(phone, profile)).toBe(false);
  });
});

describe('selectByProfiles', () => {
  const candidates = [phone, { ...phone, id: 'phone-2', tags: ['green'] }, { id: 'pen' }];

  it('takes what meets one of the profiles, once [CL-20]', () => {
    const selected = selectByProfiles(candidates, [
      { name: 'phone' },
      { tags: ['green'] },
      { id: 'phone-1' },
    ]);
    expect(selected.map(({ id }) => id)).toEqual(['phone-1', 'phone-2']);
  });

  it('takes everything when there is no profile [CL-21]', () => {
    expect(selectByProfiles(candidates, [])).toEqual(candidates);
  });
});
