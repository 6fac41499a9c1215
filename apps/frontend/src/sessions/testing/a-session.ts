import { fromJson, type Session, type SessionState } from '@ubii/proto';

/** Session for tests: one module that mirrors a position, with a topic, a constant and an output. */
export function aSession(
  changes: { name?: string; id?: string; state?: SessionState; json?: object } = {},
): Session {
  const { name = 'Two hands', id = 'session', state = 0, json = {} } = changes;
  return fromJson('ubii.sessions.Session', {
    id,
    name,
    processingModules: [
      {
        id: 'module',
        name: 'mirror',
        sessionId: id,
        status: 2,
        processingMode: { frequency: { hertz: 60 } },
        inputs: [
          { internalName: 'position', messageFormat: 'vector2' },
          { internalName: 'mirrorX', messageFormat: 'bool' },
          { internalName: 'rest', messageFormat: 'double' },
        ],
        outputs: [{ internalName: 'mirrored', messageFormat: 'vector2' }],
        onProcessingStringified: '() => ({})',
        language: 'JS',
        extension: { version: '1.0.0' },
      },
    ],
    ioMappings: [
      {
        processingModuleId: 'module',
        processingModuleName: 'mirror',
        inputMappings: [
          { inputName: 'position', topic: '/a/position' },
          { inputName: 'mirrorX', constantJson: '{"bool":true}' },
        ],
        outputMappings: [{ outputName: 'mirrored', topic: '/a/mirrored' }],
      },
    ],
    extension: { state, revision: 3 },
    ...json,
  });
}
