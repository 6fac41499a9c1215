import { RecordingReader } from '@ubii/recording';
import { serveCalls } from '@ubii/worker-rpc/browser';
import { openSource } from '../files/open-source.ts';
import type { ComparePage, CompareWorker } from './compare-messages.ts';
import { compareSession } from './compare-session.ts';

/** Compares two recordings beside the page. */
const page: ComparePage = serveCalls<CompareWorker, ComparePage>({
  async compare({ recordedFile, rerunFile, ...request }) {
    const [recorded, rerun] = await Promise.all(
      [recordedFile, rerunFile].map((file) => RecordingReader.open(openSource(file))),
    );
    return compareSession(recorded!, rerun!, request, (outputs) => page.showProgress(outputs));
  },
});
