// @vitest-environment happy-dom
import { afterEach, beforeEach, describe, expect, it, vi } from 'vitest';
import { nextStop } from './tab-stops.ts';

describe('nextStop', () => {
  let host: HTMLElement;
  const find = (id: string): HTMLElement => host.querySelector<HTMLElement>(`#${id}`)!;
  const next = (id: string, isBack = false): string | undefined => {
    const stage = find('stage');
    const element = id === 'host' ? host : find(id);
    const stop = nextStop({ host, stage, current: find('a') }, element, isBack);
    return stop === host ? 'host' : stop?.id;
  };

  beforeEach(() => {
    // The test environment has no layout.
    vi.spyOn(Element.prototype, 'getClientRects').mockReturnValue([{}] as unknown as DOMRectList);
    host = document.createElement('div');
    host.tabIndex = 0;
    host.innerHTML = `
      <div id="stage">
        <div id="a" data-graph-node="a" tabindex="-1">
          <button id="socket" tabindex="-1"></button><input id="field" /><input id="last" />
        </div>
        <div id="b" data-graph-node="b" tabindex="-1"><input id="other" /></div>
      </div>
      <button id="tool"></button><button id="tool2"></button>`;
    document.body.append(host);
  });
  afterEach(() => {
    host.remove();
    vi.restoreAllMocks();
  });

  it('goes from the canvas to the tools, past all nodes', () => {
    expect(next('host')).toBe('tool');
    expect(next('host', true)).toBeUndefined();
  });

  it('goes through the fields of the node that has the focus', () => {
    expect(next('a')).toBe('field');
    expect(next('socket')).toBe('field');
    expect(next('field')).toBe('last');
    expect(next('last')).toBe('tool');
    expect(next('field', true)).toBe('a');
    expect(next('a', true)).toBe('host');
  });

  it('comes back from the tools to the node', () => {
    expect(next('tool', true)).toBe('a');
    expect(next('tool2', true)).toBeUndefined();
    expect(next('tool')).toBeUndefined();
  });
});
