import { describe, expect, it } from 'vitest';
import { replaceClientTopics, topicParts } from './topic-parts.ts';

const ME = '0db0c43d-0000-4000-8000-000000000000';
const INES = '1db0c43d-0000-4000-8000-000000000000';
const of = (topic: string) => topicParts(topic, ME, (id) => (id === INES ? 'Ines' : undefined));

describe('topicParts', () => {
  it('has the end of the topic of a client apart, which differs', () => {
    expect(of(`/${ME}/web-interface-smart-device/touch_position`)).toEqual({
      name: 'touch_position',
      place: 'web-interface-smart-device',
      owner: undefined,
      isOwn: true,
    });
    expect(of(`/${INES}/touch_events`)).toEqual({
      name: 'touch_events',
      place: '',
      owner: 'Ines',
      isOwn: false,
    });
  });

  it('knows the owner of a topic without a slash in front', () => {
    expect(of(`${ME}/orientation`)).toMatchObject({ name: 'orientation', place: '', isOwn: true });
  });

  it('keeps the beginning of topics that are not of a client', () => {
    expect(of('/session/output')).toMatchObject({ name: 'output', place: '/session' });
    expect(of('/output')).toMatchObject({ name: '/output', place: '' });
    expect(of(`/${ME}`)).toMatchObject({ name: `/${ME}`, isOwn: false });
  });

  it('takes an end that says nothing alone with what is before it', () => {
    expect(of(`/${INES}/device/touch_position/0`)).toMatchObject({
      name: 'touch_position/0',
      place: 'device',
    });
  });
});

it('replaces topics of clients in a sentence', () => {
  const named = (topic: string): string => of(topic).name;
  expect(replaceClientTopics(`Connect /${ME}/device/x_y to a · in`, named)).toBe(
    'Connect x_y to a · in',
  );
  expect(replaceClientTopics(`Add ${ME}/orientation`, named)).toBe('Add orientation');
  expect(replaceClientTopics('Connect /session/output to a', named)).toBe(
    'Connect /session/output to a',
  );
});
