import { workerData } from 'node:worker_threads';
import { serveThread } from '@ubii/worker-rpc/node';

import { FORMATS } from '../service-format.ts';
import type { DecodeThread, DecodeThreadData } from './decode-messages.ts';
import { splitMessage } from './decode-messages.ts';

/*
 * The thread on which large bodies are decoded. It gets one after the other. Pieces of the request go
 * through a port of their own, from which they are taken one by one; then follows the reply. [SV-44]
 */
const { pieces } = workerData as DecodeThreadData;

serveThread<DecodeThread>({
  decode(format, bytes) {
    for (const piece of splitMessage(FORMATS[format].decodeRequest(bytes))) {
      pieces.postMessage(piece);
    }
  },
});
