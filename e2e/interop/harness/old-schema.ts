import { createRequire } from 'node:module';
import { join } from 'node:path';
import { inject } from 'vitest';

interface Translator {
  createBufferFromPayload(payload: object): Uint8Array;
  createPayloadFromBuffer(bytes: Uint8Array): Record<string, unknown>;
}

/** The newest published message formats (0.16.6), as web node 0.3.4 and Unity have them: independent of our own codec. */
export interface OldSchema {
  readonly request: Translator;
  readonly reply: Translator;
  readonly topicData: Translator;
}

/** Loads the message formats, which are installed beside the web node. */
export function loadOldSchema(): OldSchema {
  const installation = inject('installations').webbrowser;
  if ('missing' in installation) throw new Error(installation.missing);
  const require = createRequire(join(installation.folder, 'package.json'));
  const { ProtobufTranslator, MSG_TYPES } = require('msg-formats-0.16.6') as {
    ProtobufTranslator: new (type: string) => Translator;
    MSG_TYPES: Record<string, string>;
  };
  const translator = (name: string) => new ProtobufTranslator(MSG_TYPES[name] ?? name);
  return {
    request: translator('SERVICE_REQUEST'),
    reply: translator('SERVICE_REPLY'),
    topicData: translator('TOPIC_DATA'),
  };
}
