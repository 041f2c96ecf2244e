whenBuilt('cost', (section) => {
  for (const element of section.querySelectorAll('.cost-chart')) startCostChart(element);
});
