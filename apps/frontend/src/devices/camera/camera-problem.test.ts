import { describe, expect, it } from 'vitest';
import { cameraProblemOf, firstCameraProblem } from './camera-problem.ts';

describe('what stands between a page and the camera', () => {
  it('is known before asking where the page is insecure or the browser has none', () => {
    const of = (isSecureContext: boolean, hasMediaDevices: boolean) =>
      firstCameraProblem({ isSecureContext, hasMediaDevices })?.kind;
    expect(of(false, false)).toBe('insecure');
    expect(of(true, false)).toBe('unsupported');
    expect(of(true, true)).toBeUndefined();
  });

  it.each([
    ['NotAllowedError', 'refused'],
    ['NotFoundError', 'missing'],
    ['NotReadableError', 'in-use'],
    ['AbortError', 'in-use'],
    ['SomethingNew', 'failed'],
  ])('is told by the error %s: %s, with a way out', (name, kind) => {
    const problem = cameraProblemOf(name);
    expect(problem.kind).toBe(kind);
    expect(problem.wayOut).not.toBe('');
    expect(problem.canRetry).toBe(true);
  });
});
