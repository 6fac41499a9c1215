// @vitest-environment happy-dom
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

  it.each([
    [
      'Mozilla/5.0 (X11; Linux x86_64) AppleWebKit/537.36 Chrome/126.0 Safari/537.36',
      /turn Camera on/,
    ],
    ['Mozilla/5.0 (Windows NT 10.0; rv:128.0) Gecko/20100101 Firefox/128.0', /remove “Blocked”/],
    [
      'Mozilla/5.0 (iPhone; CPU iPhone OS 17_5) Version/17.5 Mobile Safari/604.1',
      /Website Settings/,
    ],
    ['Mozilla/5.0 (Linux; Android 14; Pixel 7) Chrome/126.0 Mobile Safari/537.36', /Permissions/],
    ['Mozilla/5.0 (Macintosh; Intel Mac OS X 14_5) Version/17.5 Safari/605.1.15', /Safari menu/],
    ['Other/1.0', /beside the address/],
  ])('after a refusal, the way out is that of the browser %s', (userAgent, way) => {
    expect(cameraProblemOf('NotAllowedError', userAgent).wayOut).toMatch(way);
  });
});
