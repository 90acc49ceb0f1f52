// The scenes to start from: the home page's, and those of the page of examples. Their names are in
// addresses.
import list from '../examples/examples.json';

export interface Example {
  readonly name: string;
  readonly title: string;
  readonly text: string;
}

const scenes = import.meta.glob<string>('../scenes/*.html', {
  query: '?raw',
  import: 'default',
  eager: true,
});

export const EXAMPLES: readonly Example[] = [
  { name: 'room', title: 'Sun, lamp and spot' },
  ...list,
].map(({ name, title }) => ({ name, title, text: scenes[`../scenes/${name}.html`] ?? '' }));
