import { fromJson, toJson, type Session } from '@ubii/proto';
import { describe, expect, it } from 'vitest';
import { isMirrorSessionOf, mirrorSession } from './mirror-session.ts';

const facts = {
  clientId: 'ada',
  clientName: 'Ada',
  module: { name: 'mirror-pointer', onProcessingStringified: '() => ({})' },
};
const whole = (spec: ReturnType<typeof mirrorSession>): Session =>
  fromJson('ubii.sessions.Session', toJson('ubii.sessions.Session', spec));

describe('mirrorSession', () => {
  it('is a whole runtime context: the source, and topics of this client only', () => {
    const session = whole(mirrorSession(facts));
    expect(session.processingModules).toMatchObject([
      { name: 'mirror-pointer', onProcessingStringified: '() => ({})' },
    ]);
    const [mapping] = session.ioMappings;
    const topics = [
      ...mapping!.inputMappings.map(({ inputName, topic }) => [inputName, topic]),
      ...mapping!.outputMappings.map(({ outputName, topic }) => [outputName, topic]),
    ];
    expect(topics).toEqual([
      ['pointer', '/ada/web-example-mouse-pointer/mouse_client_position'],
      ['mirrorX', '/ada/web-example-mouse-pointer/mirror_mouse_x'],
      ['mirrorY', '/ada/web-example-mouse-pointer/mirror_mouse_y'],
      ['mirrored', '/ada/web-example-mouse-pointer/mouse_server_position'],
    ]);
  });

  it('is found only by the client it belongs to', () => {
    const session = whole(mirrorSession(facts));
    expect(isMirrorSessionOf(session, 'ada')).toBe(true);
    expect(isMirrorSessionOf(session, 'bob')).toBe(false);
    expect(isMirrorSessionOf({ tags: ['ada'] }, 'ada')).toBe(false);
  });
});
