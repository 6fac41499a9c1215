import Fastify from 'fastify';
import { RecordingState, type Recording } from '@ubii/proto';
import { temporaryFolder } from '@ubii/program/testing';
import { expect, it } from 'vitest';
import {
  addRecordings,
  type RecordingRoutesContext,
} from '../../src/adapters/http/recording-routes.ts';
import { LOCAL_CALLER } from '../../src/core/ports/caller-facts.ts';

it('[RC-40] refuses the file of a recording that is still on its node, and says where it is', async () => {
  const recording = {
    state: RecordingState.RECORDING_STATE_AT_NODE,
    nodeName: 'Lab PC',
  } as Recording;
  const app = Fastify();
  const errors: unknown[] = [];
  app.setErrorHandler((error, _request, reply) => {
    errors.push(error);
    return reply.code(400).send();
  });
  addRecordings(app, {
    master: { requireRecording: () => Promise.resolve(recording) },
    callers: { read: () => LOCAL_CALLER },
    recordingsFolder: temporaryFolder(),
  } as unknown as RecordingRoutesContext);
  await app.inject({ method: 'HEAD', url: '/recordings/a.mcap' });
  await app.inject('/recordings/a.mcap');
  const refusal = { code: 'failed_precondition', message: expect.stringContaining('"Lab PC"') };
  expect(errors).toEqual([expect.objectContaining(refusal), expect.objectContaining(refusal)]);
  await app.close();
});
