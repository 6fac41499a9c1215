import { readdirSync, readFileSync, statSync } from 'node:fs';
import { join } from 'node:path';
import { temporaryFolder } from '@ubii/program/testing';
import { StudyRunAction, type ServiceReply } from '@ubii/proto';
import { expect, it } from 'vitest';
import { send, startEdgeMaster } from './edge-master.ts';

const CODE = 'Zebra42';

/** Paths and contents of all files in a folder. */
function filesIn(folder: string): string {
  return readdirSync(folder, { recursive: true, withFileTypes: true })
    .filter((entry) => entry.isFile())
    .map(({ parentPath, name }) => join(parentPath, name))
    .map((path) => `${path}\n${readFileSync(path, 'latin1')}`)
    .join('\n');
}

it('[ST-1] [ST-51] [ST-52] leaves no trace of a deleted participant in data directory and log', async () => {
  const dataDir = temporaryFolder();
  const { port, logged, close } = await startEdgeMaster({ dataDir });
  const call = async (name: string, payload: object): Promise<ServiceReply> => {
    const { body } = await send(port, '/services/json', {
      method: 'POST',
      headers: { 'content-type': 'application/json' },
      body: JSON.stringify({ topic: `/services/ubii/${name}`, ...payload }),
    });
    return JSON.parse(body.toString()) as ServiceReply;
  };
  const { study } = await call('study_save', {
    study: { name: 'Touch', conditions: [{ name: 'a' }] },
  });
  const studyRunStartRequest = { studyId: study!.id, participantCode: CODE };
  const { studyRun } = await call('study_run_start', { studyRunStartRequest });
  const change = (action: StudyRunAction, text = '') =>
    call('study_run_change', { studyRunChangeRequest: { runId: studyRun!.id, action, text } });
  await change(StudyRunAction.STUDY_RUN_ACTION_BEGIN_BLOCK);
  await change(StudyRunAction.STUDY_RUN_ACTION_NOTE, `${CODE} laughed`);
  const runFile = join(dataDir, 'study-runs', `${studyRun!.id}.json`);
  expect(filesIn(dataDir)).toContain(CODE);
  if (process.platform !== 'win32') expect(statSync(runFile).mode & 0o077).toBe(0);
  const studyParticipantRequest = { studyId: study!.id, participantCode: CODE };
  const { studyDeletion } = await call('study_participant_delete', { studyParticipantRequest });
  expect(studyDeletion).toMatchObject({ recordingNames: [`sub-${CODE}_ses-1_task-a_run-01`] });
  expect(filesIn(dataDir)).not.toContain(CODE);
  await close();
  expect(filesIn(dataDir)).not.toContain(CODE);
  expect(logged.join('\n')).not.toContain(CODE);
});
