import { parentPort, workerData } from 'node:worker_threads';

import { FORMATS } from '../service-format.ts';
import type { DecodeJob, DecodeWorkerData } from './decode-messages.ts';
import { splitMessage } from './decode-messages.ts';

/*
 * The thread on which large bodies are decoded. It gets one after the other. Pieces of the request go
 * through a port of their own, from which they are taken one by one; then follows the answer. [SV-44]
 */
const { pieces } = workerData as DecodeWorkerData;

parentPort!.on('message', ({ format, bytes }: DecodeJob) => {
  try {
    for (const piece of splitMessage(FORMATS[format].decodeRequest(bytes))) {
      pieces.postMessage(piece);
    }
    parentPort!.postMessage({});
  } catch (error) {
    parentPort!.postMessage({ reason: error instanceof Error ? error.message : String(error) });
  }
});
