import { decode } from '@ubii/proto';
import type { Component } from '@ubii/proto';
import { describe, expect, it } from 'vitest';
import { selectsComponent, profileToMessage } from './component-profile.ts';

const touch: Component = {
  ...decode('ubii.devices.Component', new Uint8Array()),
  id: 'c1',
  name: 'touch',
  deviceId: 'd1',
  messageFormat: 'ubii.dataStructure.Vector2',
  tags: ['smart device', 'touch'],
};

describe('selectsComponent() [CL-20]', () => {
  it.each([
    {},
    { id: 'c1' },
    { name: 'touch' },
    { deviceId: 'd1' },
    { format: 'vector2' },
    { format: 'ubii.dataStructure.Vector2' },
    { tags: ['touch'] },
    { tags: ['touch', 'smart device'], name: 'touch' },
    { name: '', tags: [] },
  ])('selects by %o', (profile) => {
    expect(selectsComponent(profile, touch)).toBe(true);
  });

  it.each([
    { id: 'c2' },
    { name: 'Touch' },
    { deviceId: 'd2' },
    { format: 'vector3' },
    { tags: ['touch', 'mouse'] },
    { name: 'touch', id: 'c2' },
  ])('does not select by %o', (profile) => {
    expect(selectsComponent(profile, touch)).toBe(false);
  });
});

describe('profileToMessage()', () => {
  it('writes only what is a criterion', () => {
    expect(profileToMessage({ name: '', format: 'vector2', tags: [] })).toEqual({
      messageFormat: 'ubii.dataStructure.Vector2',
    });
  });
});
