import { mkdtempSync, rmSync } from 'node:fs';
import { tmpdir } from 'node:os';
import { join } from 'node:path';
import { onTestFinished } from 'vitest';

/**
 * Creates a folder that is removed when the test ends.
 *
 * @param onEnd Takes what removes it. Outside of a test: `afterAll`.
 */
export function temporaryFolder(
  onEnd: (remove: () => void) => void = (remove) => onTestFinished(remove),
): string {
  const folder = mkdtempSync(join(tmpdir(), 'ubii-test-'));
  onEnd(() => rmSync(folder, { recursive: true, force: true, maxRetries: 5 }));
  return folder;
}
