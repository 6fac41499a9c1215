import type { GraphPage } from './graph-page.ts';

/**
 * All that can be seen of a graph, as text that can be compared: nodes with their places, sizes and
 * words, wires with their ways, the name of the session and how much of it is not saved.
 */
export async function pictureOf(graph: GraphPage): Promise<string> {
  const drawn = await graph.canvas.evaluate((canvas) => {
    const words = (element: HTMLElement): string =>
      element.innerText.replaceAll(/\s+/g, ' ').trim();
    const nodes = [...canvas.querySelectorAll<HTMLElement>('[data-graph-node]')].map((node) => {
      const { left, top } = node.parentElement!.style;
      const fields = [...node.querySelectorAll('input')].map(({ value }) => value);
      const area = node.querySelector<HTMLElement>('.area');
      const colors = area?.getAttribute('style') ?? '';
      const kind = [...node.classList].filter((one) => /collapsed|at-rest|resting/.test(one));
      return [
        node.getAttribute('aria-label'),
        `${left} ${top} ${node.offsetWidth} ${node.offsetHeight}`,
        words(node),
        ...fields,
        ...kind,
        colors,
      ].join(' | ');
    });
    const wires = [...canvas.querySelectorAll<HTMLElement>('[data-wire]')].map((wire) => {
      return `${wire.dataset['wire']} ${wire.querySelector('.hit')?.getAttribute('d')}`;
    });
    return [...nodes.sort(), ...wires.sort()];
  });
  const title = await graph.title.innerText();
  const life = await graph.life.innerText();
  return [title, life.replaceAll(/\s+/g, ' '), ...drawn].join('\n');
}
