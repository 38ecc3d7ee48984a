// Runs before the page appears: the theme of the system, also after it changes.
{
    const dark = matchMedia('(prefers-color-scheme: dark)');
    const follow = () => { document.documentElement.dataset.theme = dark.matches ? 'dark' : 'light'; };
    dark.addEventListener('change', follow);
    follow();
}
